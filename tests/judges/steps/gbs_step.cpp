// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of variable order: every step that is taken is that of a fixed order, whose scheme and conditions are
// checked by themselves, and its error meets the tolerance.
#include "mechanics/model/scales.hpp"
#include "methods/control/error_norm.hpp"
#include "methods/extrapolation/extrapolation.hpp"
#include "tests/judges/steps/step_checks.hpp"
#include "tests/methods/stepping.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int most_columns = 16;

/// All fixed orders on a system, and what is asked of a step.
class FixedOrders {
  public:
    FixedOrders(System& system, const std::string& base, const Accuracy& accuracy)
        : norm_(system, accuracy),
          y_(static_cast<std::size_t>(system.state_group().size())),
          error_(static_cast<std::size_t>(system.state_group().dim())) {
        for (int columns = 2; columns <= most_columns; ++columns)
            methods_.push_back((base == "chart" ? gragg(columns) : lie_midpoint(columns)).make(system, {}, {}));
    }

    /// One of them makes the step from `before` to `after` and meets the tolerance. h is what times differ by, which is
    /// rounded.
    bool have(const Real& t, const Real& h, const std::vector<Real>& before, const std::vector<Real>& after) {
        for (const auto& method : methods_) {
            method->start(t, before.data());
            if (method->attempt(t, h, before.data(), y_.data(), error_.data()) != Status::ok) continue;
            Real apart = 0;
            for (std::size_t i = 0; i < y_.size(); ++i) apart = max(apart, Real(abs(y_[i] - after[i])));
            if (apart > 100000 * epsilon) continue;
            if (norm_(h, before.data(), y_.data(), error_.data()) < 1 + Real(1) / 1000) return true;
        }
        return false;
    }

  private:
    ErrorNorm norm_;
    std::vector<std::unique_ptr<Integrator>> methods_;
    std::vector<Real> y_, error_;
};

Objection gbs_objection(const Method& method, const std::string& base) {
    const Model model = models::standard("heavy_top");
    const auto system = make_system(model, "SO3xR3"), same = make_system(model, "SO3xR3");
    const auto none = projection("none").make(*system, {});
    const Accuracy accuracy{.tolerance = Real(1) / 10000000, .length = extent(model)};
    const auto stepper = method.factory.stepper(*system, *none, accuracy, {{"base", base}}, method.description);
    FixedOrders fixed(*same, base, accuracy);
    const Real t_end = Real(1) / 4;
    std::vector<Real> y = initial_state(*system, model);
    Real t = 0;
    if (stepper->start(t, t_end, y.data()) != Status::ok) return "the start fails";
    while (t < t_end) {
        const Real begin = t;
        const std::vector<Real> before = y;
        if (stepper->step(t, t_end, y.data()) != Status::ok) return "a step fails";
        if (!fixed.have(begin, t - begin, before, y))
            return "a step at t = " + to_text(begin) + " is that of no fixed order which meets the tolerance, base " +
                   base;
    }
    return "";
}

Objection gbs_step_objection(const Method& method) {
    for (const char* base : {"group", "chart"})
        if (const Objection objection = gbs_objection(method, base); !objection.empty()) return objection;
    return "";
}

}  // namespace

KREISEL_STEP_CHECK("extrapolation/gbs", gbs_step_objection,
                   "its steps are those of fixed orders, whose conditions are checked");

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
