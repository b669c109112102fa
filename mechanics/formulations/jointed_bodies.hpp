// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies with joints of any kind: the kinematics are those of ConstrainedBodies, the solves those of JointSolver.
#pragma once

#include "mechanics/formulations/constrained_bodies.hpp"
#include "mechanics/solve/joint_solver.hpp"
#include "mechanics/solve/pivot_record.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class JointedBodies final : public ConstrainedBodies<Coordinates>, public PivotRecord {
  public:
    explicit JointedBodies(Model model, SolverChoice choice = SolverChoice::automatic);

    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override;
    Status solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override;
    Status prepare_kkt(const Real& t, const Real* q) override;
    Status solve_prepared(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override;
    Status minimise_multipliers(const Real& t, const Real* q, Real* lambda) override;
    /// The complement loses twice the digits that its rows lose.
    Real kkt_round_off() const override { return epsilon / solver_.pivot(); }
    Real least_pivot() override { return solver_.least_pivot(); }
    ConstraintRank constraint_rank() const override { return solver_.constraint_rank(); }
    std::string reason(Status status) const override {
        if (status == Status::newton_failed) return solver_.weakness();
        return status == Status::singular_kkt ? solver_.singularity() : Base::reason(status);
    }
    bool is_unique(int row) const override { return unique_[static_cast<std::size_t>(row)]; }

  private:
    using Base = ConstrainedBodies<Coordinates>;
    using Base::model;
    using Layout = BodyLayout<Coordinates>;

    /// Calls f(row of C, row in the order of the joints) for all rows.
    template <class F>
    void each_row(F f) const;
    void report(const VecX& multipliers, Real* lambda);

    JointSolver solver_;
    VecX c_;
    std::vector<bool> unique_;  // by row of C
};

template <class Coordinates>
JointedBodies<Coordinates>::JointedBodies(Model data, SolverChoice choice)
    : Base(std::move(data)),
      solver_(model(), choice),
      c_(VecX::Zero(this->constraints())),
      unique_(static_cast<std::size_t>(this->constraints()), true) {}

template <class Coordinates>
template <class F>
void JointedBodies<Coordinates>::each_row(F f) const {
    for (std::size_t j = 0; j < model().joints.size(); ++j)
        for (int k = 0; k < solver_.rows(j); ++k) f(this->row(j, k), solver_.at(j, k));
}

template <class Coordinates>
void JointedBodies<Coordinates>::report(const VecX& multipliers, Real* lambda) {
    each_row([&](int row, Eigen::Index at) {
        lambda[row] = multipliers[at] * solver_.mass_unit();
        unique_[static_cast<std::size_t>(row)] = solver_.is_unique(at);
    });
}

template <class Coordinates>
Status JointedBodies<Coordinates>::accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) {
    int body = 0;
    for (BodyNode& node : solver_.nodes()) node.motion = Layout::motion(q, v, body++);
    const Status status = solver_.accelerate(t, this->turns(), this->labels(q));
    if (status != Status::ok) return status;
    Real sum = 0;
    for (const BodyNode& node : solver_.nodes()) {
        const Vec3 A = node.a.template head<3>(), dw = node.a.template tail<3>();
        const Vec3 a = Coordinates::rate(Coordinates::from_body(node.motion.R, A), vec3(v + 3), vec3(v));
        sum += a.sum() + dw.sum();
        store(a, dv), store(dw, dv + 3);
        v += 6, dv += 6;
    }
    if (lambda) report(solver_.multipliers(), lambda);
    return isfinite(sum) ? this->turns().status() : Status::non_finite;
}

template <class Coordinates>
Status JointedBodies<Coordinates>::solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a,
                                             Real* lambda) {
    if (const Status status = prepare_kkt(t, q); status != Status::ok) return status;
    const Status status = solve_prepared(t, q, f, c, a, nullptr);
    if (status == Status::ok && lambda) report(solver_.multipliers(), lambda);
    return status;
}

template <class Coordinates>
Status JointedBodies<Coordinates>::prepare_kkt(const Real& t, const Real* q) {
    int body = 0;
    for (BodyNode& node : solver_.nodes()) node.motion = Layout::motion(q, nullptr, body++);
    return solver_.prepare(t);
}

template <class Coordinates>
Status JointedBodies<Coordinates>::minimise_multipliers(const Real& t, const Real* q, Real* lambda) {
    if (const Status status = prepare_kkt(t, q); status != Status::ok) return status;
    each_row([&](int row, Eigen::Index at) { c_[at] = lambda[row] / solver_.mass_unit(); });
    solver_.minimise_norm(c_);
    report(c_, lambda);
    return Status::ok;
}

template <class Coordinates>
Status JointedBodies<Coordinates>::solve_prepared(const Real&, const Real*, const Real* f, const Real* c, Real* a,
                                                  Real* lambda) {
    for (BodyNode& node : solver_.nodes()) {
        node.a.setZero();
        if (!f) continue;
        Vec6 wrench;
        wrench << Coordinates::to_body(node.motion.R, vec3(f)), vec3(f + 3);
        node.a = node.mobility(wrench / solver_.mass_unit());
        f += 6;
    }
    each_row([&](int row, Eigen::Index at) { c_[at] = c[row]; });
    if (const Status status = solver_.constrain(c_); status != Status::ok) return status;
    Real sum = 0;
    for (const BodyNode& node : solver_.nodes()) {
        const Vec3 A = node.a.template head<3>(), dw = node.a.template tail<3>();
        const Vec3 out = Coordinates::from_body(node.motion.R, A);
        sum += out.sum() + dw.sum();
        store(out, a), store(dw, a + 3);
        a += 6;
    }
    if (lambda)
        each_row(
            [&](int row, Eigen::Index at) { lambda[row] = solver_.basic_multipliers()[at] * solver_.mass_unit(); });
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
