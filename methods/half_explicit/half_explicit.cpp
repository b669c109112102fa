// SPDX-License-Identifier: BSD-3-Clause
#include "methods/half_explicit/half_explicit.hpp"

#include <algorithm>
#include <utility>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/implicit/mixed_kkt.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class HalfExplicit final : public Integrator {
  public:
    HalfExplicit(System& system, const HalfExplicitScheme& scheme)
        : system_(system),
          n_(static_cast<std::size_t>(system.velocities())),
          stride_(padded(2 * n_)),
          result_(scheme.result - 2),
          kkt_(system),
          u_(stride_),
          slopes_(stride_ * scheme.a.size()),
          force_(VecX::Zero(system.velocities())),
          gyroscopic_(force_),
          rows_(VecX::Zero(system.constraints())),
          lambda_(rows_),
          reported_(rows_),
          multipliers_(scheme.d.size(), rows_),
          stage_(static_cast<std::size_t>(system.state_group().size())),
          next_(stage_),
          new_(stage_) {
        for (const auto& row : scheme.a) a_.push_back(bound(row));
        for (const Coefficient& weight : scheme.d) d_.push_back(value(weight));
    }

    Status start(const Real&, const Real*) override {
        stepped_ = known_ = false;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.evaluate(t, y, system_.v(y), force_.data());
        if (!std::exchange(known_, false) || h != h_) {  // known again if this step succeeds
            const Status status = system_.accelerations(t, y, system_.v(y), force_.data(), lambda_.data());
            if (status != Status::ok) return status;
        }
        std::copy_n(y, stage_.size(), stage_.begin());
        std::fill(u_.begin(), u_.end(), Real(0));
        for (std::size_t i = 0; i < a_.size(); ++i) {
            if (const Status status = stage(i, t, h, y); status != Status::ok) return status;
            if (i == result_) new_ = next_;
            stage_.swap(next_);
        }
        std::copy(new_.begin(), new_.end(), y);
        lambda_.setZero();
        for (std::size_t i = 0; i < d_.size(); ++i) lambda_ += d_[i] * multipliers_[i];
        h_ = h, end_ = t + h, stepped_ = known_ = true;
        reported_ = lambda_, least_norm_ = false;
        return Status::ok;
    }

    const Real* multipliers() const override {
        if (!stepped_ || rows_.size() == 0) return nullptr;
        if (!least_norm_) system_.minimise_multipliers(end_, new_.data(), reported_.data());
        least_norm_ = true;
        return reported_.data();
    }

  private:
    /// A row, and the sum of its coefficients.
    struct Row {
        Combination terms;
        Real node = 0;
    };
    Row bound(const std::vector<Coefficient>& row) const {
        Row made;
        for (std::size_t j = 0; j < row.size(); ++j)
            if (!row[j].is_zero()) {
                made.terms.push_back({value(row[j]), j * stride_});
                made.node += made.terms.back().coefficient;
            }
        return made;
    }

    /// The slope of stage i, at stage_ = y u_, and next_, the point of the next row.
    Status stage(std::size_t i, const Real& t, const Real& h, const Real* y) {
        const Real now = i == 0 ? t : Real(t + a_[i - 1].node * h), end = t + a_[i].node * h;
        const Real *q = stage_.data(), *v = system_.v(stage_.data());
        Real* slope = slopes_.data() + i * stride_;
        system_.count_evaluation();
        if (!system_.group().dexpinv_left(u_.data(), v, slope)) return Status::left_chart;
        std::fill_n(slope + n_, n_, Real(0));  // v' as far as it is known
        append(i, h, y);
        system_.applied_force(now, q, v, force_.data());
        system_.gyroscopic_force(q, v, gyroscopic_.data());
        force_ += gyroscopic_;
        const Status status = rows_.size() == 0 ? solve_free(now, slope + n_)
                              : i == 0          ? pull(now, slope + n_)
                                                : solve(i, {now, q}, {end, next_.data()}, h);
        if (status != Status::ok) return status;
        Real* next_v = system_.v(next_.data());
        const Real weight = h * a_[i].terms.back().coefficient;
        for (std::size_t k = 0; k < n_; ++k) next_v[k] += weight * slope[n_ + k];
        return Status::ok;
    }

    /// next_ = y u_ of row i, as far as slopes are known.
    void append(std::size_t i, const Real& h, const Real* y) {
        combine(a_[i].terms, h, slopes_.data(), stride_, u_.data());
        ++work_.exponentials;
        system_.group().append_exp(y, u_.data(), next_.data());
        const Real* v = system_.v(y);
        Real* next_v = system_.v(next_.data());
        for (std::size_t k = 0; k < n_; ++k) next_v[k] = v[k] + u_[n_ + k];
    }

    /// v' of the first stage, with the multipliers of the last step.
    Status pull(const Real& now, Real* rate) {
        multipliers_[0] = lambda_;
        system_.apply_jacobian_transpose(now, stage_.data(), lambda_.data(), gyroscopic_.data());
        force_ -= gyroscopic_;
        system_.solve_mass(stage_.data(), force_.data(), rate);
        return Status::ok;
    }

    /// v' of a stage without constraints.
    Status solve_free(const Real& now, Real* rate) {
        const Status status = system_.prepare_kkt(now, stage_.data());
        if (status != Status::ok) return status;
        return system_.solve_prepared(now, stage_.data(), force_.data(), nullptr, rate, nullptr);
    }

    /// v' and Lambda of stage i, for which C v + b = 0 at the next point.
    Status solve(std::size_t i, const Configuration& here, const Configuration& next, const Real& h) {
        system_.velocity_residual(next.t, next.q, system_.v(next_.data()), rows_.data());
        rows_ /= -h * a_[i].terms.back().coefficient;
        multipliers_[i] = multipliers_[i - 1];
        Real* rate = slopes_.data() + i * stride_ + n_;
        return kkt_.solve(here, next, force_.data(), rows_.data(), rate, multipliers_[i].data());
    }

    System& system_;
    std::size_t n_, stride_, result_;
    MixedKkt kkt_;
    std::vector<Row> a_;
    std::vector<Real> d_, u_, slopes_;  // k and v' of a stage, one after the other
    VecX force_, gyroscopic_;           // n
    VecX rows_, lambda_;                // m
    mutable VecX reported_;
    std::vector<VecX> multipliers_;  // Lambda
    std::vector<Real> stage_, next_, new_;
    Real h_ = 0, end_ = 0;                  // of the last step
    bool known_ = false, stepped_ = false;  // lambda is that of the state; there was a step
    mutable bool least_norm_ = true;
};

}  // namespace

Factory half_explicit(const HalfExplicitScheme& scheme) {
    Factory factory;
    factory.make = [scheme](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<HalfExplicit>(system, scheme);
    };
    factory.stages = static_cast<int>(scheme.d.size());
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
