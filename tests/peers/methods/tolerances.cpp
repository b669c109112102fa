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

}  // namespace

TEST_CASE("errors are near the tolerance, and proportional to it", "[peers]") {
    for (const Method& entry : baselines())
        for (const OptionValues& options : variants(entry))
            for (const auto& [problem, formulation] :
                 {std::pair("forced_heavy_top", "SO3"), std::pair("forced_heavy_top", "SO3xR3"),
                  std::pair("forced_free_body", "SO3xR3")}) {
                const std::vector<double> found = errors(problem, formulation, entry, options);
                std::string list;
                for (const double error : found) list += " " + std::to_string(std::log10(error));
                INFO(entry.description.name << text(options) << " on " << problem << " as " << formulation << ":"
                                            << list);
                REQUIRE(found.size() == std::size(decades));
                for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] <= 1000 * std::pow(10.0, -decades[i]));
                CHECK(slope(found) == Approx(1).margin(0.3));
            }
}
