// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/joint_solver.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "mechanics/forces/forces.hpp"
#include "mechanics/model/scales.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Pivots of S are squares of those of M^{-1/2} C^T. Below this, the rows to keep are chosen again.
const Real doubtful_pivot = Real(1) / 10000000000;
/// By how much pivots fall before other rows are tried, and by how much these must be better: below that, rows kept on
/// a base that turns would amplify the drift along those dropped.
const Real fallen = Real(1) / 100, better = 10;
/// By how much accelerations may violate a dropped row, relative to the terms in its mechanism: drift violates it
/// slightly. A kept row is satisfied to more digits, or the solve has failed.
const Real dropped_row_rel_tol = Real(1) / 1000, kept_row_rel_tol = Real(1) / 1000000000;

}  // namespace

JointSolver::JointSolver(const Model& model, SolverChoice choice)
    : model_(model),
      mass_unit_(kreisel::mass_unit(model)),
      nodes_(bodies_at_start(model, mass_unit_)),
      C_(model),
      selection_(select_rows(model, C_, nodes_)),
      S_(C_, choice),
      terms_(model, C_) {
    residual_ = lambda_ = correction_ = bias_ = VecX::Zero(C_.size());
}

std::vector<BodyNode> JointSolver::bodies_at_start(const Model& model, const Real& mass_unit) {
    std::vector<BodyNode> nodes;
    for (const Body& body : model.bodies) {
        const Mat3 J = body.J / mass_unit;
        const Motion start{body.start.x, body.start.R};  // C does not depend on velocities
        nodes.push_back({inverse_mass(body) * mass_unit, J, J.inverse(), start});
    }
    return nodes;
}

RowSelection JointSolver::select_rows(const Model& model, ConstraintMatrix& C, const std::vector<BodyNode>& bodies) {
    C.evaluate(0, bodies);
    return RowSelection(model, C, bodies);
}

Status JointSolver::accelerate(const Real& t, const Turns& turns, const Real* labels) {
    move_freely(t, turns, labels);
    if (const Status status = prepare(t); status != Status::ok) return status;
    C_.acceleration_bias(residual_);
    return react(true);
}

/// a = M^{-1} (forces, gyroscopic torque).
void JointSolver::move_freely(const Real& t, const Turns& turns, const Real* labels) {
    const Vec3 g = model_.gravity.at(t);
    for (BodyNode& node : nodes_) {
        const Vec3& w = node.motion.omega;
        node.a << node.motion.R.transpose() * g, node.J_inverse * (node.J * w).cross(w);
    }
    const Motion rest;
    for_each_wrench(
        model_, t,
        [&](int body) -> const Motion& {
            return body == ground ? rest : nodes_[static_cast<std::size_t>(body)].motion;
        },
        [&](std::size_t i, const Turn& turn) { return turns.angle(i, turn, t, labels); },
        [&](int body, const Wrench& wrench) {
            Vec6 both;
            both << wrench.force / mass_unit_, wrench.torque / mass_unit_;
            BodyNode& node = nodes_[static_cast<std::size_t>(body)];
            node.a += node.mobility(both);
        });
}

Status JointSolver::prepare(const Real& t) {
    C_.evaluate(t, nodes_);
    return choose_and_factor();
}

Status JointSolver::choose_and_factor() {
    if (C_.joints() == 0) return Status::ok;
    C_.evaluate_mobilities(nodes_);
    pivot_ = S_.factor(C_, selection_);
    if (!isfinite(pivot_)) return Status::non_finite;
    least_pivot_ = min(least_pivot_, pivot_);
    doubtful_ = pivot_ <= doubtful_pivot;
    if (doubtful_) return choose_again();
    best_pivot_ = max(best_pivot_, pivot_);
    if (!selection_.is_complete() && pivot_ < fallen * best_pivot_) choose_better();
    return Status::ok;
}

void JointSolver::choose_better() {
    best_pivot_ = pivot_;
    const std::optional<RowChoice> fresh = selection_.best(C_, selection_.rank());
    if (!fresh || fresh->rank < selection_.rank()) return;
    const RowSelection before = selection_;
    selection_.set(*fresh);
    const Real pivot = S_.factor(C_, selection_);
    if (pivot > better * pivot_) {
        best_pivot_ = pivot_ = pivot;
        return;
    }
    selection_ = before;
    pivot_ = S_.factor(C_, selection_);
}

/// As many rows as before: the most independent ones at the present configuration.
Status JointSolver::choose_again() {
    const std::optional<RowChoice> fresh = selection_.best(C_, selection_.rank());
    if (!fresh) return Status::non_finite;
    if (fresh->rank < selection_.rank()) {
        const auto is_dependent = [&](Eigen::Index row) { return !fresh->independent[static_cast<std::size_t>(row)]; };
        singularity_ = "rank " + std::to_string(fresh->rank) + " of the constraints, " +
                       std::to_string(selection_.rank()) +
                       " at the start; dependent: " + C_.names_of_rows(is_dependent);
        return Status::singular_kkt;
    }
    selection_.set(*fresh);
    pivot_ = S_.factor(C_, selection_);
    if (pivot_ > 0) return Status::ok;  // nearly dependent rows are used
    singularity_ = "the masses differ so much that the rows kept cannot be told apart in this precision";
    return isfinite(pivot_) ? Status::singular_kkt : Status::non_finite;
}

Status JointSolver::constrain(const VecX& c) {
    residual_ = -c;
    return react(false);
}

Status JointSolver::react(bool watch) {
    if (C_.joints() == 0) return Status::ok;
    bias_ = residual_;
    evaluate_residual(false);
    watch = watch && !selection_.is_complete();
    if (watch || doubtful_) terms_.clear(), terms_.add_all(C_, nodes_, bias_), terms_.compare(C_, nodes_);
    lambda_ = residual_;
    S_.solve(lambda_);
    C_.subtract_reaction(lambda_, nodes_);
    if (watch && !dropped_rows_hold()) return Status::singular_kkt;
    return !doubtful_ || refine() ? Status::ok : Status::singular_kkt;
}

void JointSolver::evaluate_residual(bool all_rows) {
    residual_ = bias_;
    C_.apply(nodes_, residual_);
    if (selection_.is_complete() || all_rows) return;
    for (Eigen::Index i = 0; i < residual_.size(); ++i)
        if (!selection_.is_kept(i)) residual_[i] = 0;
}

bool JointSolver::refine() {
    evaluate_residual(false);
    correction_ = residual_;
    S_.solve(correction_);
    lambda_ += correction_;
    C_.subtract_reaction(correction_, nodes_);
    evaluate_residual(false);
    terms_.add_accelerations(C_, nodes_);
    terms_.compare(C_, nodes_);
    return hold(true, kept_row_rel_tol,
                "rows that depend on each other but for round-off, by position or by the masses, are not met: ");
}

bool JointSolver::dropped_rows_hold() {
    evaluate_residual(true);
    return hold(false, dropped_row_rel_tol, "rows that followed from others at the start are violated: ");
}

bool JointSolver::hold(bool those_kept, const Real& share, const char* what) {
    std::string names;
    for (std::size_t j = 0; j < C_.joints(); ++j)
        for (int k = 0; k < C_.rows(j); ++k) {
            const Eigen::Index row = at(j, k);
            if (selection_.is_kept(row) == those_kept && terms_.is_beyond(residual_[row], share, j, row))
                names += (names.empty() ? "" : ", ") + C_.name_of_row(j, k);
        }
    if (!names.empty()) singularity_ = what + names;
    return names.empty();
}

const VecX& JointSolver::multipliers() {
    minimise_norm(lambda_);
    return lambda_;
}

void JointSolver::minimise_norm(VecX& lambda) {
    if (!selection_.is_complete()) least_norm_.minimise(C_, selection_, terms_.scale(), S_, lambda);
}

std::string JointSolver::weakness() const {
    constexpr int weak = 1000;
    if (!(weak * pivot_ < 1)) return "";
    const std::optional<RowChoice> others = selection_.best(C_, selection_.rank() - 1);
    if (!others) return "";
    const std::string names = C_.names_of_rows([&](Eigen::Index row) {
        return selection_.is_kept(row) && !others->independent[static_cast<std::size_t>(row)];
    });
    return "close to a pose in which the constraints lose rank: " + names + " all but follow from the others";
}

ConstraintRank JointSolver::constraint_rank() const {
    ConstraintRank rank{C_.size(), selection_.rank(), {}, selection_.condition()};
    for (std::size_t j = 0; j < C_.joints(); ++j)
        for (int k = 0; k < C_.rows(j); ++k)
            if (!selection_.is_kept(at(j, k))) rank.redundant.push_back(C_.name_of_row(j, k));
    return rank;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
