// SPDX-License-Identifier: BSD-3-Clause
//
// kreisel's methods in formulations and with projections of one's choice.
#include <sstream>
#include <stdexcept>

#include "benchmarks/accuracy/contender.hpp"
#include "methods/simulation.hpp"
#include "problems/problem.hpp"

namespace accuracy {

namespace {

using namespace kreisel;

Model heavy_top() {
    const Problem& top = problem("heavy_top");
    return top.build(Parameters(default_parameters(top.description)));
}

struct Choice {
    std::string method, formulation, projection = "none";
    OptionValues options = {};
};

/// "rkmk/rk4;coordinates=cayley".
void read_method(const std::string& text, Choice& c) {
    std::istringstream words(text);
    std::getline(words, c.method, ';');
    for (std::string word; std::getline(words, word, ';');) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos) throw std::invalid_argument("expected OPTION=VALUE, got \"" + word + "\"");
        c.options[word.substr(0, equals)] = word.substr(equals + 1);
    }
}

Choice choice(const std::string& text) {
    std::istringstream words(text);
    Choice c;
    std::string method_and_options;
    std::getline(words, method_and_options, ':'), std::getline(words, c.formulation, ':');
    read_method(method_and_options, c);
    if (c.formulation.empty())
        throw std::invalid_argument("expected METHOD[;OPTION=VALUE]:FORMULATION[:PROJECTION], got \"" + text + "\"");
    if (words) std::getline(words, c.projection);
    method(c.method), formulation(c.formulation), projection(c.projection);  // these throw
    return c;
}

class KreiselRun final : public Run {
  public:
    /// Steps where there are any, else a tolerance.
    KreiselRun(const Choice& c, long steps, double tolerance)
        : steps_(steps),
          simulation_(heavy_top(), {.formulation = c.formulation,
                                    .method = c.method,
                                    .options = c.options,
                                    .projection = c.projection,
                                    .tolerance = tolerance}) {}
    bool integrate() override {
        const Real end = t_end;
        return (steps_ > 0 ? simulation_.advance(end, steps_) : simulation_.advance(end)) == Status::ok;
    }
    std::array<double, 3> position() const override {
        const Vec3 x = simulation_.bodies()[0].x;
        return {x[0], x[1], x[2]};
    }
    long evaluations() const override { return simulation_.system().evaluations(); }

  private:
    long steps_;
    Simulation simulation_;
};

}  // namespace

std::vector<Contender> kreisel_contenders(const std::string& text) {
    const Choice c = choice(text);
    const MethodDescription& method = kreisel::method(c.method).description;
    std::vector<Contender> all;
    if (!method.own_control)
        all.push_back({Contender::Kind::kreisel, text, true, step_counts(4, 65536),
                       [c](double n) { return std::make_unique<KreiselRun>(c, static_cast<long>(n), 0); }});
    if (method.own_control || method.estimate > 0)
        all.push_back({Contender::Kind::kreisel, text, false, tolerances(1e-5, 1e-14),
                       [c](double tolerance) { return std::make_unique<KreiselRun>(c, 0, tolerance); }});
    return all;
}

}  // namespace accuracy
