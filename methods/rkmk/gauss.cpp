// SPDX-License-Identifier: BSD-3-Clause
//
// Unknowns of the iteration are the slopes k_i and w_i = h f_i (methods/implicit/newton.hpp); the last f_i make the
// step.
#include "methods/rkmk/gauss.hpp"

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/implicit/motion_scale.hpp"
#include "methods/implicit/newton.hpp"
#include "methods/implicit/predictor.hpp"
#include "methods/implicit/remoteness.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

struct Collocation {
    MatX a;
    VecX b, c;
};

Collocation two_stages() {
    const Real quarter = Real(1) / 4, r = sqrt(Real(3)) / 6;
    Collocation made{MatX(2, 2), VecX(2), VecX(2)};
    made.a << quarter, quarter - r, quarter + r, quarter;
    made.b << Real(1) / 2, Real(1) / 2;
    made.c << Real(1) / 2 - r, Real(1) / 2 + r;
    return made;
}

Collocation three_stages() {
    const Real outer = Real(5) / 36, inner = Real(2) / 9, r = sqrt(Real(15));
    Collocation made{MatX(3, 3), VecX(3), VecX(3)};
    made.a << outer, inner - r / 15, outer - r / 30,  //
        outer + r / 24, inner, outer - r / 24,        //
        outer + r / 30, inner + r / 15, outer;
    made.b << 2 * outer, 2 * inner, 2 * outer;
    made.c << Real(1) / 2 - r / 10, Real(1) / 2, Real(1) / 2 + r / 10;
    return made;
}

class Gauss final : public Integrator, private Equations {
  public:
    Gauss(System& system, Collocation tableau)
        : system_(system),
          tableau_(std::move(tableau)),
          n_(system.velocities()),
          stages_(tableau_.b.size()),
          newton_(2 * n_ * stages_),
          scale_(system),
          remoteness_of_(system),
          past_(2 * n_ * stages_),
          turned_(VecX::Zero(2 * n_ * stages_)),
          weights_(VecX::Ones(turned_.size())),
          k_(MatX::Zero(n_, stages_)),
          w_(k_),
          f_(k_),
          half_(VecX::Zero(n_)),
          u_(half_),
          stage_v_(half_),
          difference_(half_),
          middle_(static_cast<std::size_t>(system.group().size())),
          stage_q_(middle_) {}

    Status start(const Real&, const Real*) override {
        newton_.forget(), scale_.forget(), past_.clear();
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        t_ = t, h_ = h, q_ = y, v_ = system_.v(y);
        scale_.weigh(y);
        if (const Status status = guess(); status != Status::ok) return status;
        motion_ = scale_.of_motion(t, h, y);
        remoteness_ = remoteness_of_.measure(y);
        const Status status = solve();
        work_.newton_iterations = newton_.iterations();
        if (status != Status::ok) {
            past_.clear();
            return status;
        }
        past_.push(turned_);
        Eigen::Map<VecX> v(system_.v(y), n_);
        for (Eigen::Index i = 0; i < stages_; ++i) v += h * tableau_.b[i] * f_.col(i);
        u_ = 2 * half_;
        system_.group().append_exp(y, u_.data(), y);
        return Status::ok;
    }

  private:
    /// From the steps before, or from constant f at the start and where something is stiff.
    Status guess() {
        if (h_ != known_h_) newton_.forget(), past_.clear();
        known_h_ = h_;
        if (!past_.empty() && !newton_.stiff()) {
            past_.guess(past_.best_degree(turned_.size()), turned_);
            return Status::ok;
        }
        const Status status = system_.evaluate(t_, q_, v_, f_.data());
        for (Eigen::Index i = 0; i < stages_; ++i) {
            difference_ = h_ * f_.col(0);
            scale_.to_space(q_, difference_.data(), slope_of_velocity(i));
            difference_ = Eigen::Map<const VecX>(v_, n_) + tableau_.c[i] * difference_;
            scale_.to_space(q_, difference_.data(), slope_of_position(i));
        }
        return status;
    }

    /// From the guess, and where that leads nowhere from an unchanged velocity: springs that are stiff make f swing.
    Status solve() {
        const Status status = newton_.solve(*this, weights_, turned_.data());
        if (status != Status::newton_failed) return status;
        turned_.setZero();
        for (Eigen::Index i = 0; i < stages_; ++i) scale_.to_space(q_, v_, slope_of_position(i));
        return newton_.solve(*this, weights_, turned_.data());
    }

    /// k_i and w_i among the unknowns.
    Real* slope_of_position(Eigen::Index i) { return turned_.data() + i * n_; }
    Real* slope_of_velocity(Eigen::Index i) { return turned_.data() + (stages_ + i) * n_; }

    /// k - dexp^{-1}(V) and w - h f. Iterates may turn farther than the final step: only the last one is checked, at
    /// the end of the step.
    Status residual(const Real* turned, Real* r) override {
        for (Eigen::Index i = 0; i < stages_; ++i) {
            scale_.from_space(q_, turned + i * n_, k_.col(i).data());
            scale_.from_space(q_, turned + (stages_ + i) * n_, w_.col(i).data());
        }
        half_.setZero();
        for (Eigen::Index i = 0; i < stages_; ++i) half_ += h_ / 2 * tableau_.b[i] * k_.col(i);
        system_.group().append_exp(q_, half_.data(), middle_.data());
        for (Eigen::Index i = 0; i < stages_; ++i) {
            const Status status = stage(i, r + i * n_, r + (stages_ + i) * n_);
            if (status != Status::ok && status != Status::turn_lost) return status;
        }
        return Status::ok;
    }

    Status stage(Eigen::Index i, Real* of_position, Real* of_velocity) {
        u_ = -half_;
        stage_v_ = Eigen::Map<const VecX>(v_, n_);
        for (Eigen::Index j = 0; j < stages_; ++j) {
            u_ += h_ * tableau_.a(i, j) * k_.col(j);
            stage_v_ += tableau_.a(i, j) * w_.col(j);
        }
        system_.group().append_exp(middle_.data(), u_.data(), stage_q_.data());
        if (!system_.group().dexpinv_left(u_.data(), stage_v_.data(), difference_.data())) return Status::left_chart;
        difference_ = k_.col(i) - difference_;
        scale_.to_space(q_, difference_.data(), of_position);
        const Status status =
            system_.evaluate(t_ + tableau_.c[i] * h_, stage_q_.data(), stage_v_.data(), f_.col(i).data());
        difference_ = w_.col(i) - h_ * f_.col(i);
        scale_.to_space(q_, difference_.data(), of_velocity);
        return status;
    }

    Real size() const override {
        Real most = motion_;
        for (Eigen::Index i = 0; i < stages_; ++i)
            most = max(most, Real(abs(h_) * scale_.of_velocity(f_.col(i).data())));
        return most;
    }
    Real round_off() const override { return remoteness_ * system_.kkt_round_off(); }

    System& system_;
    const Collocation tableau_;
    Eigen::Index n_, stages_;
    Newton newton_;
    MotionScale scale_;
    Remoteness remoteness_of_;
    Predictor past_;                        // of turned_
    VecX turned_, weights_;                 // all k_i, then all w_i, in space axes
    MatX k_, w_, f_;                        // a column a stage
    VecX half_, u_, stage_v_, difference_;  // half_: theta/2
    std::vector<Real> middle_, stage_q_;
    Real t_ = 0, h_ = 0, known_h_ = 0, motion_ = 0, remoteness_ = 1;
    const Real *q_ = nullptr, *v_ = nullptr;  // start of the step
};

}  // namespace

Factory gauss(int stages) {
    Factory factory;
    factory.make = [stages](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<Gauss>(system, stages == 2 ? two_stages() : three_stages());
    };
    factory.stages = stages;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
