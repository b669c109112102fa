// SPDX-License-Identifier: BSD-3-Clause
#include "methods/variational/rattle_equations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

RattleEquations::RattleEquations(System& system, IncrementChart chart)
    : system_(system),
      chart_(chart),
      n_(system.velocities()),
      m_(system.constraints()),
      positions_(system.position_constraints()),
      mass_(system),
      configuration_(static_cast<std::size_t>(system.group().size())),
      v_(VecX::Zero(n_)),
      start_(v_),
      push_(v_),
      u_(v_),
      momentum_(v_),
      pulled_(v_),
      force_(v_),
      rate_(v_),
      zero_(v_),
      rows_(VecX::Zero(m_)) {}

void RattleEquations::begin(const Real& t, const Real& h, const Real* q, const Real* v) {
    t_ = t, h_ = h, q_ = q;
    v_ = Eigen::Map<const VecX>(v, n_);
    mass_.weigh(q);
    mass_.multiply(v, start_.data());
    system_.conservative_force(t, q, push_.data());
    push_ *= h / 2;
}

void RattleEquations::place(const Real* D) {
    u_ = h_ * Eigen::Map<const VecX>(D, n_);
    const Group& group = system_.group();
    chart_ == IncrementChart::exp ? group.append_exp(q_, u_.data(), configuration_.data())
                                  : group.append_cay(q_, u_.data(), configuration_.data());
}

/// The group's transposes are of left-trivialised maps, those at -u.
bool RattleEquations::pull_back(const VecX& u, const VecX& p, VecX& out) const {
    out = -u;
    const Group& group = system_.group();
    if (chart_ == IncrementChart::exp) return group.dexpinv_left_transpose(out.data(), p.data(), out.data());
    group.dcayinv_left_transpose(out.data(), p.data(), out.data());
    return true;
}

Status RattleEquations::residual(const Real* x, Real* r) {
    const Eigen::Map<const VecX> D(x, n_);
    Eigen::Map<VecX> difference(r, n_);
    place(x);
    mass_.multiply(x, momentum_.data());
    if (!pull_back(u_, momentum_, pulled_)) return Status::left_chart;
    force_ = push_ + (momentum_ - pulled_);
    if (m_ > 0) {
        system_.apply_jacobian_transpose(t_, q_, x + n_, rate_.data());
        force_ -= rate_;
    }
    system_.solve_mass(q_, force_.data(), rate_.data());
    difference = D - v_ - rate_;  // not M^{-1} M v, whose round-off has the same sign at every step
    if (m_ == 0) return Status::ok;
    const Real end = t_ + h_;
    const Real* q = configuration_.data();
    force_ = -difference;
    system_.apply_jacobian(end, q, force_.data(), rows_.data());
    Eigen::Map<VecX> phi(r + n_, m_);
    system_.position_residual(end, q, phi.data());
    rows_ += phi / h_;
    if (const Status status = system_.prepare_kkt(end, q); status != Status::ok) return status;
    return system_.solve_prepared(end, q, zero_.data(), rows_.data(), rate_.data(), phi.data());
}

void RattleEquations::settle(Real* x, const Real* r) {
    Eigen::Map<VecX>(x, n_ + m_) -= Eigen::Map<const VecX>(r, n_ + m_);
    if (m_ > 0) {
        system_.apply_jacobian_transpose(t_, q_, r + n_, force_.data());
        system_.solve_mass(q_, force_.data(), rate_.data());
        Eigen::Map<VecX>(x, n_) += rate_;
    }
    place(x);
    mass_.multiply(x, momentum_.data());
}

bool RattleEquations::gain() {
    u_ = -u_;
    if (!pull_back(u_, momentum_, pulled_)) return false;
    system_.conservative_force(t_ + h_, configuration_.data(), force_.data());
    force_ = (pulled_ - start_) + h_ / 2 * force_;
    return true;
}

Status RattleEquations::kick(Real* w) {
    if (!gain()) return Status::left_chart;
    system_.solve_mass(configuration_.data(), force_.data(), w);
    Eigen::Map<VecX>(w, n_) += v_;
    return Status::ok;
}

Status RattleEquations::finish(Real* v, Real* lambda) {
    const Real end = t_ + h_;
    const Real* q = configuration_.data();
    if (!gain()) return Status::left_chart;
    if (m_ > 0) {
        system_.velocity_residual(end, q, v_.data(), rows_.data());
        rows_ = -rows_;
    }
    if (const Status status = system_.prepare_kkt(end, q); status != Status::ok) return status;
    const Status status = system_.solve_prepared(end, q, force_.data(), rows_.data(), v, m_ > 0 ? lambda : nullptr);
    Eigen::Map<VecX>(v, n_) += v_;
    for (Eigen::Index i = 0; i < m_; ++i) lambda[i] *= 2 / h_;
    return status;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
