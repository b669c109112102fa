// SPDX-License-Identifier: BSD-3-Clause
//
// BLieDF method with k = 2, the backward differentiation formula on Lie groups in the stabilised index-2 form
// [wieloch2021]: with the increments D of q+ = q exp(h D),
//   v+ = 3/2 (D + M^{-1} C(q)^T eta) - 1/2 D_previous,   h v'+ = 3/2 v+ - 2 v + 1/2 v_previous,
//   M v'+ + C^T lambda+ = Q,   Phi(q+) = 0,   C(q+) v+ + b = 0.
// No bracket is needed for order 2: D is the velocity in the middle of its step up to O(h^2).
// Own start: one step of rkmk/rk4 from (t, y) by -h gives v_previous and, by D_previous = log(q_previous^-1 q) / h, the
// increment that led to q; the index-1 form keeps both on the constraints up to O(h^5). A change of h starts afresh.
#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/implicit/stabilised_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::unique_ptr<Integrator> bind_standard(const Method& method, System& system) {
    return method.factory.make(system, with_defaults({}, method.description.options), method.description);
}

class BLieDF2 final : public Integrator {
  public:
    explicit BLieDF2(System& system)
        : system_(system),
          step_(system),
          starter_(bind_standard(method("rkmk/rk4"), system)),
          previous_v_(VecX::Zero(system.velocities())),
          previous_increment_(previous_v_),
          v_(previous_v_),
          past_(static_cast<std::size_t>(system.state_group().size())) {}

    Status start(const Real&, const Real*) override {
        h_ = 0;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.evaluate(t, y, system_.v(y), v_.data());
        if (h != h_)
            if (const Status status = begin(t, h, y); status != Status::ok) return status;
        h_ = 0;  // until this step has succeeded
        v_ = Eigen::Map<const VecX>(system_.v(y), v_.size());
        step_.velocity_slope = Real(2) / 3;
        step_.velocity_offset = (4 * v_ - previous_v_) / 3;
        step_.increment_slope = Real(4) / 9;
        step_.increment_offset = (2 * step_.velocity_offset + previous_increment_) / 3;
        const Status status = step_.advance(t, h, y);
        work_.newton_iterations = step_.iterations();
        if (status != Status::ok) return status;
        previous_v_ = v_;
        previous_increment_ = step_.increment();
        h_ = h, stepped_ = true;
        return Status::ok;
    }

    const Real* multipliers() const override { return stepped_ ? step_.multipliers() : nullptr; }

  private:
    /// The step that would have led to y.
    Status begin(const Real& t, const Real& h, const Real* y) {
        stepped_ = false;
        if (const Status status = step_.start(t, h, y); status != Status::ok) return status;
        std::copy_n(y, past_.size(), past_.begin());
        if (const Status status = starter_->step(t, -h, past_.data()); status != Status::ok) return status;
        const Group& group = system_.group();
        previous_v_ = Eigen::Map<const VecX>(system_.v(past_.data()), v_.size());
        group.inverse(past_.data(), past_.data());
        group.multiply(past_.data(), y, past_.data());
        group.log(past_.data(), previous_increment_.data());
        previous_increment_ /= h;
        return Status::ok;
    }

    System& system_;
    StabilisedStep step_;
    std::unique_ptr<Integrator> starter_;
    VecX previous_v_, previous_increment_, v_;
    std::vector<Real> past_;
    Real h_ = 0;  // step that the memory belongs to; 0: none
    bool stepped_ = false;
};

Factory bliedf2() {
    Factory factory;
    factory.make = [](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<BLieDF2>(system);
    };
    return factory;
}

}  // namespace

KREISEL_METHOD(bliedf2(), {.name = "multistep/bliedf2",
                           .order = 2,
                           .cites = {"wieloch2021", "gear1985", "munthekaas1998"},
                           .summary = "backward differentiation formula BLieDF with k = 2, stabilised index-2 form",
                           .variable_cost = true,
                           .form = Form::implicit,
                           .reports_multipliers = true,
                           .meets_positions = true,
                           .meets_velocities = true,
                           .keeps_memory = true,
                           .preserves = {{Property::constraints, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
