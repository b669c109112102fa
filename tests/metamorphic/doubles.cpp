// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/doubles.hpp"

#include "mechanics/formulation.hpp"
#include "mechanics/forwarding_system.hpp"
#include "mechanics/joints/joint_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

class AbsoluteProjection final : public Projection {
  public:
    explicit AbsoluteProjection(System& system)
        : system_(system),
          none_(VecX::Zero(system.velocities())),
          residual_(VecX::Zero(system.constraints())),
          delta_(none_) {}

    Status project(const Real& t, Real* y) override {
        for (int i = 0; i < 20; ++i) {
            residual_.setZero();
            system_.position_residual(t, y, residual_.data());
            if (residual_.lpNorm<Eigen::Infinity>() <= Real(1) / 1000000000) return Status::ok;
            residual_ = -residual_;
            const Status status = system_.solve_kkt(t, y, none_.data(), residual_.data(), delta_.data(), nullptr);
            if (status != Status::ok) return status;
            system_.group().append_exp(y, delta_.data(), y);
        }
        return Status::projection_failed;
    }

  private:
    System& system_;
    VecX none_, residual_, delta_;
};

/// In SO3xR3. The model's own torsion springs have been taken away; theirs act here, between the ground and a body.
class ForgetfulSprings final : public ForwardingSystem {
  public:
    ForgetfulSprings(std::unique_ptr<System> inner, std::vector<TorsionSpring> springs)
        : ForwardingSystem(std::move(inner)),
          springs_(std::move(springs)),
          states_(static_cast<std::size_t>(bodies())) {}

    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        VecX torques = VecX::Zero(velocities()), none = VecX::Zero(constraints()), more(velocities());
        std::vector<Real> y(q, q + state_group().size());
        std::copy_n(v, velocities(), this->v(y.data()));
        inner().read(y.data(), states_.data());
        for (const TorsionSpring& spring : springs_) {
            const BodyState& s = states_[static_cast<std::size_t>(spring.second)];
            const Vec3 first = s.R * spring.axes_second.col(0), axis = spring.axes_first.col(2);
            const Real theta = atan2(first.dot(spring.axes_first.col(1)), first.dot(spring.axes_first.col(0)));
            const Real torque = -spring.stiffness * (theta - spring.angle) - spring.damping * axis.dot(s.R * s.omega);
            torques.segment<3>(6 * spring.second + 3) += s.R.transpose() * axis * torque;
        }
        const Status status = inner().solve_kkt(t, q, torques.data(), none.data(), more.data(), nullptr);
        if (status != Status::ok) return status;
        const Status answer = inner().accelerations(t, q, v, dv, lambda);
        Eigen::Map<VecX>(dv, velocities()) += more;
        return answer;
    }

  private:
    std::vector<TorsionSpring> springs_;
    std::vector<BodyState> states_;
};

class ReversedRollingRow final : public ForwardingSystem {
  public:
    ReversedRollingRow(std::unique_ptr<System> inner, const Model& model)
        : ForwardingSystem(std::move(inner)), model_(model) {}

    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        const Status status = inner().accelerations(t, q, v, dv, lambda);
        std::size_t row = 0;
        for (const Joint& joint : model_.joints) {
            if (joint.type == "rolling" && lambda) lambda[row] = -lambda[row];
            row += static_cast<std::size_t>(position_rows_of(joint.type));
        }
        return status;
    }

  private:
    Model model_;
};

class HiddenTime final : public Integrator {
  public:
    explicit HiddenTime(std::unique_ptr<Integrator> inner) : inner_(std::move(inner)) {}
    Status start(const Real& t, const Real* y) override { return inner_->start(t, y); }
    Status step(const Real& t, const Real& h, Real* y) override {
        if (abs(h) <= Real(1) / 128) return inner_->step(t, h, y);
        const Status status = inner_->step(t, h / 2, y);
        return status == Status::ok ? inner_->step(t + h / 2, h / 2, y) : status;
    }

  private:
    std::unique_ptr<Integrator> inner_;
};

}  // namespace

Bench with_absolute_tolerance() {
    Bench bench;
    bench.projection = [](System& system, const Combination&) { return std::make_unique<AbsoluteProjection>(system); };
    return bench;
}

Bench with_forgetful_springs() {
    Bench bench;
    bench.system = [](Model model, const std::string& formulation) {
        const auto springs = std::move(model.torsion_springs);
        model.torsion_springs.clear();
        return std::make_unique<ForgetfulSprings>(make_system(model, formulation), springs);
    };
    return bench;
}

Bench with_reversed_rolling_row() {
    Bench bench;
    bench.system = [](const Model& model, const std::string& formulation) {
        return std::make_unique<ReversedRollingRow>(make_system(model, formulation), model);
    };
    return bench;
}

Bench with_uninvited_spring() {
    Bench bench;
    bench.system = [](Model model, const std::string& formulation) {
        for (std::size_t i = 0; i < model.bodies.size(); ++i)
            if (model.bodies[i].name == "rod")
                model.springs.push_back(
                    {.second = static_cast<int>(i), .r_first = Vec3(1, 1, 1), .stiffness = 25, .length = 1});
        return make_system(model, formulation);
    };
    return bench;
}

Bench with_hidden_time() {
    Bench bench;
    const auto usual = bench.integrator;
    bench.integrator = [usual](System& system, const Combination& combination) {
        return std::make_unique<HiddenTime>(usual(system, combination));
    };
    return bench;
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
