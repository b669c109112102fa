// SPDX-License-Identifier: BSD-3-Clause
//
// The trapezoidal Lie-Newmark method (Newmark's on a group [simovuquoc1988], with beta = 0 and gamma = 1/2), explicit
// in the forces [kryslendres2005], for systems without joints: velocity Verlet as it is written for vector spaces, in
// body axes,
//   V = v + h/2 a(t, q, v),   q+ = q tau(h V),   v+ = V + h/2 a(t + h, q+, v+),   M a = f(t, q) + gyroscopic(v),
// tau = exp or cay; v+ is found by iteration, in which only the gyroscopic term changes. Symmetric. Looks symplectic,
// and is not where rotations do not commute: momenta are kept to O(h^2) only, and a step changes the two-form by O(h^3)
// (compare methods/variational/lie_verlet.cpp).
#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/implicit/motion_scale.hpp"
#include "methods/implicit/newton/newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class LieNewmark final : public Integrator, private Equations {
  public:
    LieNewmark(System& system, bool cayley)
        : system_(system),
          cayley_(cayley),
          newton_(system.velocities()),
          scale_(system),
          q_(static_cast<std::size_t>(system.group().size())),
          V_(VecX::Zero(system.velocities())),
          f_(V_),
          sum_(V_),
          a_(V_),
          v_(V_),
          turned_(V_),
          weights_(VecX::Ones(V_.size())) {}

    Status start(const Real&, const Real*) override {
        newton_.forget(), scale_.forget();
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.accelerations(t, y, system_.v(y), a_.data(), nullptr);
        scale_.weigh(y);
        size_ = scale_.of_motion(t, h, y);
        if (!isfinite(size_)) return Status::non_finite;
        v_ = Eigen::Map<const VecX>(system_.v(y), v_.size());
        load(t, y);
        accelerate(y);
        V_ = v_ + h / 2 * a_;
        move(h, y);
        load(t + h, q_.data());
        v_ = V_ + h / 2 * a_;
        const Status status = iterate(h);
        if (status != Status::ok) return status;
        std::copy(q_.begin(), q_.end(), y);
        std::copy_n(v_.data(), v_.size(), system_.v(y));
        return Status::ok;
    }

  private:
    void load(const Real& t, const Real* q) {
        system_.count_evaluation();
        system_.conservative_force(t, q, f_.data());
    }
    /// a_ at (q, v_) under the force f_.
    void accelerate(const Real* q) {
        system_.gyroscopic_force(q, v_.data(), sum_.data());
        sum_ += f_;
        system_.solve_mass(q, sum_.data(), a_.data());
    }
    /// q_ = q tau(h V).
    void move(const Real& h, const Real* q) {
        sum_ = h * V_;
        cayley_ ? system_.group().append_cay(q, sum_.data(), q_.data())
                : system_.group().append_exp(q, sum_.data(), q_.data());
        ++work_.exponentials;
    }

    /// v+ from the guess v_.
    Status iterate(const Real& h) {
        if (h != h_) newton_.forget();
        h_ = h;
        scale_.to_space(q_.data(), v_.data(), turned_.data());
        const Status status = newton_.solve(*this, weights_, turned_.data());
        scale_.from_space(q_.data(), turned_.data(), v_.data());
        work_.newton_iterations = newton_.iterations();
        return status;
    }
    Status residual(const Real* turned, Real* r) override {
        scale_.from_space(q_.data(), turned, v_.data());
        accelerate(q_.data());
        sum_ = (v_ - V_) - h_ / 2 * a_;
        scale_.to_space(q_.data(), sum_.data(), r);
        return Status::ok;
    }
    Real size() const override { return size_; }

    System& system_;
    bool cayley_;
    Newton newton_;
    MotionScale scale_;
    std::vector<Real> q_;  // q+
    VecX V_, f_, sum_, a_, v_, turned_, weights_;
    Real h_ = 0, size_ = 0;
};

std::string why_not_newmark(const System& system) {
    if (system.is_dissipative()) return "forces that depend on velocities (dampers)";
    return system.constraints() > 0 ? "joints" : "";
}

Factory lie_newmark() {
    Factory factory;
    factory.options = {{.name = "coordinates",
                        .summary = "of increments: exponential or Cayley map",
                        .standard = std::string("exp"),
                        .choices = {"exp", "cayley"}}};
    factory.make = [](System& system, const OptionValues& options, const MethodDescription&) {
        return std::make_unique<LieNewmark>(system, std::get<std::string>(options.at("coordinates")) == "cayley");
    };
    factory.declines = why_not_newmark;
    return factory;
}

}  // namespace

KREISEL_METHOD(lie_newmark(), {.name = "variational/lie_newmark",
                               .order = 2,
                               .cites = {"kryslendres2005", "simovuquoc1988"},
                               .summary = "trapezoidal Lie-Newmark method, explicit in the forces; not symplectic",
                               .force_evaluations = 2,
                               .form = Form::implicit,
                               .preserves = {{Property::symmetric, Domain::potential}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
