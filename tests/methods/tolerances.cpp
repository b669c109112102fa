// SPDX-License-Identifier: BSD-3-Clause
//
// Errors at the end follow the tolerance: the slope of log error against log tolerance is p/r for a method that advances
// order p by an estimate O(h^r). In quad, where a reference far below the smallest error is at hand.
#include <cmath>

#include "engine/reference/reference.hpp"
#include "mechanics/model/scales.hpp"
#include "tests/methods/controlled_trip.hpp"

#if KREISEL_QUAD

using namespace stepping;

namespace {

constexpr int t_end = 6;

const ReferenceSolution& reference_motion() {
    static const ReferenceSolution solution = reference_solution(models::standard("forced_heavy_top"), t_end);
    return solution;
}

/// Slope of a least-squares line.
double slope_of(const std::vector<std::pair<double, double>>& points) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [a, b] : points) n += 1, x += a, y += b, xx += a * a, xy += a * b;
    return (n * xy - x * y) / (n * xx - x * x);
}

std::string proportionality_objection(const Method& entry) {
    const Model model = models::standard("forced_heavy_top");
    const MethodDescription& method = entry.description;
    const int decades = method.order.configuration >= 5 ? 6 : 4;
    std::vector<std::pair<double, double>> points;
    for (int half = 0; half <= 2 * decades; ++half) {
        const double exponent = -4 - half / 2.0;
        ControlledTrip trip(model, "SO3xR3", entry,
                            {.tolerance = Real(std::pow(10.0, exponent)), .length = extent(model)});
        if (trip.run(t_end) != Status::ok) return "a run fails";
        if (half == 0 && trip.stepper->accepted() < 20)
            return "only " + std::to_string(trip.stepper->accepted()) + " steps";
        std::vector<BodyState> states(model.bodies.size());
        trip.system->read(trip.y.data(), states.data());
        points.push_back({exponent, std::log10(to_double(worst(distance(states, reference_motion().states))))});
    }
    const double expected = static_cast<double>(method.order.configuration) / method.estimate;
    const double found = slope_of(points);
    return std::abs(found - expected) <= 0.15 ? ""
                                              : "errors follow the tolerance with slope " + std::to_string(found) +
                                                    ", not " + std::to_string(expected);
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
