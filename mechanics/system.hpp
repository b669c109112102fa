// SPDX-License-Identifier: BSD-3-Clause
//
// What a method sees: a constrained mechanical system on a Lie group G, in left-trivialised velocities v in R^n,
//
//   q' = q v^,   M(q) v' + C(t,q)^T lambda = Q(t,q,v),   C(t,q) v + b(t,q) = 0,   Phi(t,q) = 0,
//
// the position rows Phi being part of the velocity rows. Differentiated once more, C v' = xi(t,q,v), which gives the
// index-1 form [M C^T; C 0] [v'; lambda] = [Q; xi] [terzezlatarmueller, eq. 10, with the sign of the multipliers that
// makes eqs. 13, 14 and 20 agree].
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lie/group.hpp"
#include "lie/status.hpp"
#include "mechanics/joints/reaction.hpp"
#include "mechanics/model/model.hpp"
#include "mechanics/turns.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// What first integrals are functions of, the same in every formulation: the bodies, and the angles of the torsion
/// springs (rad, all turns counted).
struct MotionState {
    std::span<const BodyState> bodies;
    std::span<const Real> angles = {};
};

/// A quantity constant along the exact flow, and why.
struct FirstIntegral {
    std::string name, unit, reason;
    std::function<Real(const MotionState&)> value;
    std::function<Real(const MotionState&)> size;  ///< sum of the sizes of its terms: what its round-off scales with
};

/// How many constraint rows there are and how many of them are independent in the initial configuration. Rows that
/// follow from others are left out of the solves; the multipliers are then those of least norm, each row divided by its
/// System::row_scale.
struct ConstraintRank {
    int rows = 0, rank = 0;
    std::vector<std::string> redundant;  ///< the rows left out, by joint
    std::optional<Real> condition;       ///< ratio of the extreme pivots of M^{-1/2} C^T, its columns of length 1
};

/// States are y = (q, v) in TG. Vectors of dimension n live in the velocity coordinates of the formulation; constraint
/// rows are in space axes. Work space belongs to the object: one object per thread.
class System {
  public:
    explicit System(std::shared_ptr<const Group> configurations);
    virtual ~System() = default;
    System(const System&) = delete;
    System& operator=(const System&) = delete;

    const Group& group() const { return *group_; }
    const TangentGroup& state_group() const { return state_group_; }
    int velocities() const { return group_->dim(); }                    ///< n
    virtual int constraints() const { return 0; }                       ///< m, rows of C
    virtual int position_constraints() const { return constraints(); }  ///< rows of Phi, the first of C
    /// The parts of a state y = (q, v) in TG, and v' of a slope z = (v, v').
    const Real* q(const Real* y) const { return y; }
    Real* q(Real* y) const { return y; }
    const Real* v(const Real* y) const { return state_group_.v(y); }
    Real* v(Real* y) const { return state_group_.v(y); }
    Real* dv(Real* z) const { return state_group_.dv(z); }

    /// v' at (q, v). Counted as a solve of the dynamics.
    Status evaluate(const Real& t, const Real* q, const Real* v, Real* dv) {
        ++evaluations_;
        return accelerations(t, q, v, dv, nullptr);
    }
    /// Right-hand side of y' = y F(t, y) on TG: z = (v, v') [terzezlatarmueller, eq. 9].
    Status vector_field(const Real& t, const Real* y, Real* z) {
        const Real* velocity = v(y);
        for (int i = 0; i < velocities(); ++i) z[i] = velocity[i];
        return evaluate(t, q(y), velocity, dv(z));
    }
    /// For methods that evaluate the equations of motion instead of solving them: counted alike.
    void count_evaluation() { ++evaluations_; }
    /// Solves and other counted evaluations of the dynamics since construction.
    long evaluations() const { return evaluations_; }

    /// Solves the index-1 system for v' (n) and lambda (m; may be null).
    virtual Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) = 0;
    /// Solves [M C^T; C 0] [a; lambda] = [f; c] for given f (n; null: zero), c (m).
    virtual Status solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda);
    /// The same for several right-hand sides at one (t, q): `prepare_kkt` factors, and until any other solve
    /// `solve_prepared` at this (t, q) uses the factors. Where rows are redundant its multipliers are some that yield
    /// a, not those of least norm; lambda may be null.
    virtual Status prepare_kkt(const Real&, const Real*) { return Status::ok; }
    virtual Status solve_prepared(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) {
        return solve_kkt(t, q, f, c, a, lambda);
    }
    /// Turns multipliers into those of least norm with the same C^T lambda.
    virtual Status minimise_multipliers(const Real&, const Real*, Real*) { return Status::ok; }
    /// Relative accuracy of a solution of the last KKT system: eps times the condition of the complement.
    virtual Real kkt_round_off() const { return epsilon; }

    /// Mass matrix: blocks of `mass_block()` rows, one after another, column by column.
    virtual int mass_block() const { return velocities(); }
    virtual bool mass_is_constant() const { return true; }
    virtual void mass(const Real* q, Real* blocks) const;
    virtual void solve_mass(const Real* q, const Real* f, Real* a) const;  ///< a = M^{-1} f
    /// Q = applied + gyroscopic; variational methods need only the first.
    virtual void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const;
    virtual void gyroscopic_force(const Real* q, const Real* v, Real* f) const;
    /// applied = conservative + dissipative, each of n. The first is the applied force at v = 0: gravity, the elastic
    /// part of springs, and loads; without loads it is minus the gradient of the potential. The second is that of
    /// dampers, f . v <= 0, and zero where not is_dissipative().
    virtual void conservative_force(const Real& t, const Real* q, Real* f) const;
    virtual void dissipative_force(const Real& t, const Real* q, const Real* v, Real* f) const;
    virtual bool is_dissipative() const { return false; }

    virtual void position_residual(const Real&, const Real*, Real*) const {}  ///< Phi
    virtual void jacobian(const Real&, const Real*, Real*) const {}           ///< C, column by column
    /// C v (m) and C^T lambda (n) without a dense matrix, where the model has structure.
    virtual void apply_jacobian(const Real& t, const Real* q, const Real* v, Real* product) const;
    virtual void apply_jacobian_transpose(const Real& t, const Real* q, const Real* lambda, Real* f) const;
    virtual void velocity_bias(const Real& t, const Real* q, Real* b) const;               ///< b = dPhi/dt
    virtual void velocity_residual(const Real&, const Real*, const Real*, Real*) const {}  ///< C v + b
    virtual void acceleration_bias(const Real&, const Real*, const Real*, Real*) const {}  ///< xi
    /// Scale of each row (m, or 1 where it compares directions): residuals are judged relative to it, wherever the
    /// mechanism is.
    virtual void row_scale(Real* scale) const;
    /// Sum of the sizes of the terms of each row of Phi (m or 1), distances from the origin among them: what the
    /// round-off of the row is relative to.
    virtual void position_scale(const Real* q, Real* scale) const;

    virtual ConstraintRank constraint_rank() const { return {constraints(), constraints(), {}, {}}; }
    /// The joints and directions of the rows of C.
    virtual std::vector<ConstraintRow> constraint_rows() const {
        return std::vector<ConstraintRow>(static_cast<std::size_t>(constraints()));
    }
    /// After a solve for lambda: whether the multiplier of a row is unique. It is not if the null space of C^T involves
    /// the row.
    virtual bool is_unique(int) const { return true; }
    /// What the joints of the model exert in its order under the multipliers lambda (m), those of another method or of
    /// accelerations. Where the formulation eliminates the joints, it follows from Newton's law, and lambda is ignored.
    virtual Status reactions(const Real&, const Real*, const Real*, const Real*, JointReaction*) { return Status::ok; }
    /// Explains the status of the last evaluation in words: after singular_kkt where the constraints lost rank, after
    /// turn_lost which spring and why. Empty if there is nothing to add.
    virtual std::string reason(Status) const { return ""; }

    /// Torsion springs count full turns, which poses forget. q has a label for each behind the poses
    /// (mechanics/turns.hpp); a step that a method makes stands between begin_step and end_step (Method::bind
    /// sees to that), so that stages know where angles are expected, and the labels are those of the last step that
    /// succeeded.
    int torsion_springs() const { return group_->size() - poses_; }
    Real* labels(Real* q) const { return q + poses_; }
    const Real* labels(const Real* q) const { return q + poses_; }
    /// Before a step by h from y(t): returns ok or turn_lost.
    virtual Status begin_step(const Real& /*t*/, const Real& /*h*/, const Real* /*y*/) { return Status::ok; }
    /// After it, at y(t), where `result` is what the step returned: returns the same, or turn_lost.
    virtual Status end_step(Status result, const Real& /*t*/, Real* /*y*/) { return result; }
    /// The angles of the torsion springs outside a step.
    virtual void read_angles(const Real* /*q*/, SpringAngle* /*angles*/) const {}

    /// Jacobian of the rows (Phi, C v + b) in ambient coordinates, where R is any 3x3 matrix: columns are the entries
    /// of q and then v; 2m rows, column by column.
    virtual bool has_ambient_jacobian() const { return false; }
    virtual void ambient_jacobian(const Real&, const Real*, const Real*, Real*) const {}

    virtual bool has_potential() const { return false; }
    /// V(t, q), where has_potential().
    virtual Real potential(const Real&, const Real*) const { return 0; }

    virtual int bodies() const { return 0; }
    /// Reads the state of each body; writes one back (what is reported is always x, R, v, omega), labels staying as
    /// they are.
    virtual void read(const Real*, BodyState*) const {}
    virtual void write(const BodyState*, Real*) const {}

    virtual void complement_diagonal(const Real& t, const Real* q, Real* diagonal) const;  ///< of C M^{-1} C^T

    const std::vector<FirstIntegral>& integrals() const { return integrals_; }
    void set_integrals(std::vector<FirstIntegral> integrals) { integrals_ = std::move(integrals); }

  private:
    std::shared_ptr<const Group> group_;
    TangentGroup state_group_;
    int poses_;  // reals of q before the labels
    std::vector<FirstIntegral> integrals_;
    long evaluations_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
