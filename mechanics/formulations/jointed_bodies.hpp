// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies with joints of any kind: the kinematics are those of Bodies, the solves those of JointSolver.
#pragma once

#include "mechanics/formulations/bodies.hpp"
#include "mechanics/solve/joint_solver.hpp"
#include "mechanics/solve/pivot_record.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class JointedBodies final : public Bodies<Coordinates>, public PivotRecord {
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
    using Base = Bodies<Coordinates>;
    using Base::motion, Base::model;

    /// Calls f(row of C, row in the order of the joints) for all rows.
    template <class F>
    void each_row(F f) const;
    void report(const VecX& multipliers, Real* lambda);

    JointSolver solver_;
    VecX c_;
    std::vector<bool> unique_;  // by row of C
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
