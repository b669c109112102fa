// SPDX-License-Identifier: BSD-3-Clause
//
// Generalised-alpha method on Lie groups in the index-3 form [bruelscardona2010], [bruels2012], [arnold2015]: the steps
// of generalized_alpha.hpp with Phi(q+) = 0. Velocities leave C v + b = 0 by O(h^2), because the local error of q,
//   h l,   l = h^2 (1/6 - beta - (alpha_m - alpha_f)/2) v'' + h^2/12 [v, v'],
// has a part along C that positions cannot keep. From velocities that satisfy C v + b = 0, a and lambda are wrong by
// O(h) in the first steps, a transient that is damped like rho^n; it does not arise from v(0) + Delta with
//   [M C^T; C 0] (Delta, .) = (0, C l)                       [arnold2015], start = "perturbed".
// The bracket is that of left trivialisation, v^ v' in the paper.
#include "methods/generalized_alpha/generalized_alpha.hpp"
#include "methods/implicit/position_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class PositionAlpha final : public GeneralisedAlpha<PositionStep> {
  public:
    PositionAlpha(System& system, const AlphaParameters& parameters, bool perturbed)
        : GeneralisedAlpha(system, parameters),
          perturbed_(perturbed),
          rows_(VecX::Zero(system.constraints())),
          defect_(rows_) {}

  private:
    /// The velocities of y may be some that earlier steps have left: those on the constraints are perturbed.
    Status perturb(const Real& t, const Real& h, const Real* y) override {
        const Eigen::Index positions = system_.position_constraints();
        if (!perturbed_ || positions == 0) return Status::ok;
        system_.group().bracket(v_.data(), rate_.data(), shift_.data());
        shift_ = (Real(1) / 6 - p_.beta - (p_.alpha_m - p_.alpha_f) / 2) * jerk_ + h / 12 * shift_;
        system_.apply_jacobian(t, y, shift_.data(), rows_.data());
        rows_.tail(rows_.size() - positions).setZero();
        system_.velocity_residual(t, y, v_.data(), defect_.data());
        rows_ -= defect_;
        shift_.setZero();
        if (const Status status = system_.prepare_kkt(t, y); status != Status::ok) return status;
        const Status status = system_.solve_prepared(t, y, shift_.data(), rows_.data(), near_rate_.data(), nullptr);
        v_ += near_rate_;
        return status;
    }

    bool perturbed_;
    VecX rows_, defect_;
};

Factory position_alpha() {
    Factory factory = alpha_factory([](System& system, const OptionValues& options, const MethodDescription&) {
        const auto start = options.find("start");
        const bool perturbed = start == options.end() || start->second == OptionValue("perturbed");
        return std::make_unique<PositionAlpha>(system, alpha_parameters(options), perturbed);
    });
    factory.options.push_back({.name = "start",
                               .summary = "velocities of the first step: exact, or perturbed by O(h^2) so that "
                                          "multipliers have order 2 from the first step on",
                               .standard = "perturbed",
                               .choices = {"perturbed", "exact"}});
    return factory;
}

}  // namespace

KREISEL_METHOD(position_alpha(),
               {.name = "generalized_alpha/index3",
                .order = 2,
                .cites = {"bruelscardona2010", "bruels2012", "arnold2015", "chunghulbert1993"},
                .summary = "generalised-alpha method on Lie groups, index-3 form, start perturbed or not",
                .variable_cost = true,
                .projectable = false,
                .form = Form::implicit,
                .reports_multipliers = true,
                .meets_positions = true,
                .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
