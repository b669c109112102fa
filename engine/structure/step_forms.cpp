// SPDX-License-Identifier: BSD-3-Clause
#include "engine/structure/step_forms.hpp"

#include "engine/structure/step_derivative.hpp"
#include "engine/structure/tangent_frame.hpp"
#include "engine/structure/two_form.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// The form has the square of their number of entries, and each takes six steps.
constexpr int most_freedoms = 64;

std::string why_not_defined(const System& system) {
    if (system.is_dissipative()) return "dampers take energy";
    if (!system.has_potential()) return "forces have no potential, or one that changes with time";
    if (system.position_constraints() < system.constraints()) return "rolling is not holonomic";
    if (!system.mass_is_constant()) return "the mass matrix depends on the configuration";
    if (system.velocities() - system.constraint_rank().rank > most_freedoms)
        return "there are more than " + std::to_string(most_freedoms) + " degrees of freedom";
    return "";
}

/// The two-form at y over vectors (xi, w), columns, with mu = M v.
MatX form_at(const System& system, const Real* y, const MatX& vectors, const Real& sign) {
    const Eigen::Index n = system.velocities();
    const VecX mu = times_mass(system, system.q(y), Eigen::Map<const VecX>(system.v(y), n));
    return two_form(system.group(), mu, vectors.topRows(n), times_mass(system, system.q(y), vectors.bottomRows(n)),
                    sign);
}

StepForms no_forms(std::string reason) {
    StepForms none;
    none.why_not = std::move(reason);
    return none;
}

}  // namespace

StepForms step_forms(const ObservedStep& at, const Real& sign) {
    if (std::string reason = why_not_defined(at.system); !reason.empty()) return no_forms(std::move(reason));
    MotionUnits units(at.system, at.length);
    const Real rate = units.rate(at.t, at.h, at.y);
    if (!(rate > 0)) return no_forms("the accelerations cannot be solved for at this state");
    TangentFrame frame = tangent_frame(at.system, at.t, at.y, rate);
    if (!frame.why_not.empty()) return no_forms(std::move(frame.why_not));
    const StepDerivative A = derivative_of(at, frame.vectors, units, rate);
    if (A.status != Status::ok) return no_forms(std::string("a step ends in ") + name(A.status));
    StepForms forms;
    forms.rate = rate;
    forms.before = form_at(at.system, at.y, frame.vectors, sign);
    forms.after = form_at(at.system, A.y1.data(), A.fine, sign);
    forms.coarse = form_at(at.system, A.y1.data(), A.coarse, sign);
    // A step has the round-off of some dozens of operations.
    forms.round_off = 64 * StepDerivative::round_off() * units.remoteness(at.y) * sqrt(Real(forms.before.cols()));
    return forms;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
