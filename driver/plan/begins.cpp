// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/begins.hpp"

#include <fmt/format.h>

#include <set>

#include "records/json/diagnostics.hpp"

namespace kreisel {

namespace {

constexpr const char* begin_pointer = "/time/begin";

class Begins {
  public:
    Begins(const Engines& engines, Diagnostics& sink, Plan& plan) : engines_(engines), sink_(sink), plan_(plan) {}

    void check(const ProblemPoint& problem, const std::string& formulation) {
        for (const std::string& precision : plan_.config.precisions) {
            const BeginCheck check = engines_.of(precision).check_begin(problem.name(), problem.parameters(),
                                                                        formulation, *plan_.config.begin);
            if (!check.fault.empty()) {
                const std::string sentence = fmt::format("{}: {}", problem.label(), check.fault);
                if (refused_.insert(sentence).second) { sink_.add_sentence(begin_pointer, sentence, Rule::begin); }
            } else if (check.drifts) {
                warn(fmt::format("{} in {} misses its joints by {:.2g} m and {:.2g} m/s, as the run had drifted",
                                 problem.label(), formulation, check.position, check.velocity));
            }
        }
    }

    void tell_what_starts_anew() {
        const std::string when = fmt::format("at t = {} s", plan_.config.begin->t.value);
        for (const OptionedEntry& method : plan_.config.methods) {
            if (!engines_.binary64.method(method.name, method.options).keeps_memory) { continue; }
            warn(fmt::format("{} starts anew {}: no sample has what it remembers of earlier steps", method.name, when));
        }
        if (!plan_.config.tolerances.empty()) {
            warn(fmt::format("steps to a tolerance start anew {}: no sample has their size", when));
        }
    }

  private:
    void warn(const std::string& sentence) {
        if (warned_.insert(sentence).second) {
            plan_.warnings.push_back(fmt::format("{}: {}", begin_pointer, sentence));
        }
    }

    const Engines& engines_;
    Diagnostics& sink_;
    Plan& plan_;
    std::set<std::string> refused_, warned_;
};

}  // namespace

void check_begins(const Engines& engines, Diagnostics& sink, Plan& plan) {
    const Config& config = plan.config;
    if (!config.begin) { return; }
    Begins begins(engines, sink, plan);
    const std::size_t formulations = config.formulations.size();
    for (std::size_t i = 0; i < config.problems.size(); ++i) {
        for (std::size_t j = 0; j < formulations; ++j) {
            if (!plan.systems.at(i * formulations + j)->skip_reason.empty()) { continue; }
            begins.check(config.problems[i], config.formulations[j]);
        }
    }
    begins.tell_what_starts_anew();
}

}  // namespace kreisel
