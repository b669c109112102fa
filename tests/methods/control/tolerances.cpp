// SPDX-License-Identifier: BSD-3-Clause
//
// Errors at the end follow the tolerance: the slope of log error against log tolerance is p/r for a method that
// advances order p by an estimate O(h^r). In quad, where a reference far below the smallest error is at hand.
#include <cmath>
#include <map>
#include <optional>

#include "engine/reference/reference.hpp"
#include "mechanics/model/scales.hpp"
#include "tests/methods/control/controlled_trip.hpp"

#if KREISEL_QUAD

using namespace stepping;

namespace {

constexpr int t_end = 6;

const ReferenceSolution& reference_motion(const std::string& problem) {
    static std::map<std::string, ReferenceSolution> known;
    const auto found = known.find(problem);
    if (found != known.end()) return found->second;
    return known[problem] = reference_solution(models::standard(problem), t_end);
}

/// Slope of a least-squares line.
double slope_of(const std::vector<std::pair<double, double>>& points) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [a, b] : points) n += 1, x += a, y += b, xx += a * a, xy += a * b;
    return (n * xy - x * y) / (n * xx - x * x);
}

/// Slope of log error over log tolerance; nothing where a run fails or takes too few steps.
std::optional<double> proportionality(const Method& entry, const std::string& problem) {
    const Model model = models::standard(problem);
    // Coarser tolerances lie before the range where leading terms decide, the more so the higher the order.
    const bool high = entry.description.order.configuration >= 5;
    const int decades = high ? 6 : 4, first = high ? -8 : -5;
    std::vector<std::pair<double, double>> points;
    for (int decade = 0; decade <= decades; ++decade) {
        const double exponent = first - decade;
        ControlledTrip trip(model, "SO3xR3", entry,
                            {.tolerance = Real(std::pow(10.0, exponent)), .length = extent(model)});
        if (trip.run(t_end) != Status::ok || trip.stepper->accepted() < 20) return {};
        std::vector<BodyState> states(model.bodies.size());
        trip.system->read(trip.y.data(), states.data());
        const Distance apart = distance(states, reference_motion(problem).states);
        points.push_back({exponent, std::log10(to_double(worst(apart)))});
    }
    return slope_of(points);
}

/// A leading error can be so small on one problem that those of the next order decide, and slopes are too large: never
/// too small a slope, and on one problem the right one.
std::string proportionality_objection(const Method& entry) {
    const double expected = static_cast<double>(entry.description.order.configuration) / entry.description.estimate;
    std::string objection;
    for (const char* problem : {"forced_heavy_top", "double_pendulum"}) {
        const std::optional<double> found = proportionality(entry, problem);
        if (!found) return std::string("a run on ") + problem + " fails or takes less than 20 steps";
        if (std::abs(*found - expected) <= 0.15) return "";
        objection = "errors follow the tolerance with slope " + std::to_string(*found) + " on " + problem + ", not " +
                    std::to_string(expected);
        if (*found < expected) return objection;
    }
    return objection;
}

/// rkmk/dopri5 with another estimate of its error: e h^power, or none.
class Misjudging final : public Integrator {
  public:
    Misjudging(System& system, int power)
        : inner_(method("rkmk/dopri5").bind(system, default_options(method("rkmk/dopri5").description.options))),
          dim_(system.state_group().dim()),
          power_(power) {}
    Status start(const Real& t, const Real* y) override { return inner_->start(t, y); }
    Status step(const Real& t, const Real& h, Real* y) override { return inner_->step(t, h, y); }
    Status attempt(const Real& t, const Real& h, const Real* y, Real* y_new, Real* error) override {
        const Status status = inner_->attempt(t, h, y, y_new, error);
        const Real factor = power_ < 0 ? Real(0) : Real(pow(Real(2 * h), power_));
        for (int i = 0; i < dim_; ++i) error[i] *= factor;
        return status;
    }
    void accept(bool moved) override { inner_->accept(moved); }

  private:
    std::unique_ptr<Integrator> inner_;
    int dim_, power_;
};

Method misjudging(int power) {
    Method entry = method("rkmk/dopri5");
    entry.factory.make = [power](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<Misjudging>(system, power);
    };
    return entry;
}

}  // namespace

TEST_CASE("errors follow the tolerance as declared", "[tolerance]") {
    for (const Method& entry : methods()) {
        if (entry.description.estimate == 0) continue;
        INFO(entry.description.name);
        CHECK(proportionality_objection(entry) == "");
    }
}

TEST_CASE("estimates of another order, or of zero, are seen by their errors", "[tolerance][control]") {
    CHECK_THAT(proportionality_objection(misjudging(1)), Catch::Contains("with slope"));
    CHECK(proportionality_objection(misjudging(-1)) != "");
}

#endif
