// SPDX-License-Identifier: BSD-3-Clause
//
// What a tolerance brings: errors near it, and proportional to it, over six decades.
#include "tests/peers/methods/approach.hpp"

using namespace kreisel;
using namespace peers;

namespace {

constexpr int decades[] = {4, 5, 6, 7, 8, 9, 10};

/// Errors over tolerances 1e-4 to 1e-10; empty where a run fails.
std::vector<double> errors(const std::string& problem, const std::string& formulation, const Method& entry,
                           const OptionValues& options) {
    std::vector<double> found;
    for (const int decade : decades) {
        Approach run(models::standard(problem), formulation, entry, options, pow(Real(10), -decade));
        if (run.run({1}) != Status::ok) return {};
        found.push_back(to_double(error_at_1(problem, run)));
    }
    return found;
}

/// Slope of the least-squares line through log10 error over log10 tolerance.
double slope(const std::vector<double>& errors) {
    double x_mean = 0, y_mean = 0, xy = 0, xx = 0;
    const double n = static_cast<double>(errors.size());
    for (std::size_t i = 0; i < errors.size(); ++i) x_mean += -decades[i] / n, y_mean += std::log10(errors[i]) / n;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double x = -decades[i] - x_mean;
        xy += x * (std::log10(errors[i]) - y_mean), xx += x * x;
    }
    return xy / xx;
}

/// What speaks against a method on the acceptance problems, or "". The slope of a pair is that of its order over that
/// of its estimate, 1; a variable order scatters.
std::string tolerance_objection(const Method& entry, const OptionValues& options) {
    const double band = entry.description.stages > 0 ? 0.15 : 0.3;
    for (const auto& [problem, formulation] :
         {std::pair("forced_heavy_top", "SO3"), std::pair("forced_heavy_top", "SO3xR3"),
          std::pair("forced_free_body", "SO3xR3")}) {
        const std::vector<double> found = errors(problem, formulation, entry, options);
        const std::string where = std::string(" on ") + problem + " as " + formulation;
        if (found.size() != std::size(decades)) return "a run fails" + where;
        for (std::size_t i = 0; i < found.size(); ++i)
            if (!(found[i] <= 1000 * std::pow(10.0, -decades[i])))
                return "error " + std::to_string(found[i]) + " at 1e-" + std::to_string(decades[i]) + where;
        if (!(std::abs(slope(found) - 1) <= band)) return "slope " + std::to_string(slope(found)) + where;
    }
    return "";
}

}  // namespace

TEST_CASE("errors are near the tolerance, and proportional to it", "[peers]") {
    for (const Method& entry : baselines())
        for (const OptionValues& options : variants(entry)) {
            INFO(entry.description.name << text(options));
            CHECK(tolerance_objection(entry, options) == "");
        }
}

TEST_CASE("control: a tolerance that is ignored, or taken for another one, is seen", "[peers][control]") {
    for (const bool ignored : {true, false}) {
        Method control = method("baseline/odeint_rkf78");
        control.factory.stepper = [=, sound = control.factory.stepper](System& system, Projection& project,
                                                                       Accuracy accuracy, const OptionValues& options,
                                                                       const MethodDescription& description) {
            accuracy.tolerance = ignored ? Real(1) / 10000000 : sqrt(accuracy.tolerance);
            return sound(system, project, accuracy, options, description);
        };
        CHECK(tolerance_objection(control, {}) != "");
    }
}
