// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/joint_solver.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <map>

#include "mechanics/forces/forces.hpp"
#include "mechanics/model/scales.hpp"
#include "mechanics/solve/forest.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Pivots of S are squares of those of M^{-1/2} C^T. Below this, the rows to keep are chosen again.
const Real doubtful_pivot = Real(1) / 10000000000;
/// By how much accelerations may violate a dropped row, relative to the terms in its mechanism: drift violates it
/// slightly. A kept row is satisfied to more digits, or the solve has failed.
const Real dropped_row_rel_tol = Real(1) / 1000, kept_row_rel_tol = Real(1) / 1000000000;
/// Fraction of scale omega^2 that counts as a term where the terms themselves vanish. It is small because a body spins
/// fast about a symmetry axis without any acceleration: all of omega^2 would hide contradictory joints.
const Real spin_term_share = Real(1) / 10000;

}  // namespace

JointSolver::JointSolver(const Model& model, SolverChoice choice)
    : model_(model),
      rows_(model.joints.size()),
      mass_unit_(kreisel::mass_unit(model)),
      length_(body_lengths(model)),
      island_(islands(model)) {
    for (const Body& body : model_.bodies) {
        const Mat3 J = body.J / mass_unit_;
        nodes_.push_back({inverse_mass(body) * mass_unit_, J, J.inverse(), {}});
    }
    largest_.resize(nodes_.size());
    connect();
    solver_ = make_solver(matrix_, choice);
    residual_ = lambda_ = correction_ = sizes_ = bias_ = VecX::Zero(matrix_.size);
    scale_.resize(matrix_.size);
    for (std::size_t j = 0; j < rows_.size(); ++j)
        for (int k = 0; k < matrix_.rows[j]; ++k) scale_[at(j, k)] = row_scale(model_, model_.joints[j], k);
    choose_rows_at_start();
}

void JointSolver::connect() {
    for (std::size_t j = 0; j < rows_.size(); ++j) {
        const Joint& joint = model_.joints[j];
        matrix_.add_joint(rows_of(joint.type));
        if (joint.first != ground) ends_.push_back({j, static_cast<std::size_t>(joint.first), &rows_[j].first});
        if (joint.second != ground) ends_.push_back({j, static_cast<std::size_t>(joint.second), &rows_[j].second});
    }
    std::vector<std::vector<std::size_t>> on_body(nodes_.size());
    for (std::size_t e = 0; e < ends_.size(); ++e) on_body[ends_[e].body].push_back(e);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> entry;
    for (const auto& ends : on_body)
        for (const std::size_t a : ends)
            for (const std::size_t b : ends) {
                const std::size_t row = ends_[a].joint, col = ends_[b].joint;
                if (row < col) continue;
                if (row == col) {
                    pairs_.push_back({a, b, row, true});
                    continue;
                }
                const auto [place, fresh] = entry.insert({{row, col}, matrix_.entries.size()});
                if (fresh) matrix_.entries.push_back({static_cast<int>(row), static_cast<int>(col)});
                pairs_.push_back({a, b, place->second, false});
            }
    matrix_.lower.assign(matrix_.entries.size(), Mat6::Zero());
}

void JointSolver::choose_rows_at_start() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const BodyState& start = model_.bodies[i].start;
        nodes_[i].motion = {start.x, start.R};  // C does not depend on velocities
    }
    evaluate_rows(0);
    const int rows = matrix_.size;
    constexpr int few = 200;
    if (rows > few && is_forest(model_)) {
        choice_ = {std::vector<bool>(static_cast<std::size_t>(rows), true), rows};
    } else {
        choice_ = choose_rows(geometric_transpose(), rows);
        if (choice_.rank > 0 && rows <= 2 * few)
            if (const Real ratio = condition(); isfinite(ratio)) condition_ = ratio;
    }
    complete_ = choice_.rank == rows;
}

template <class Weigh>
MatX JointSolver::transpose(Weigh weigh) const {
    MatX A = MatX::Zero(6 * static_cast<Eigen::Index>(nodes_.size()), matrix_.size);
    for (const End& end : ends_)
        for (int k = 0; k < matrix_.rows[end.joint]; ++k)
            A.block<6, 1>(6 * static_cast<Eigen::Index>(end.body), at(end.joint, k)) +=
                weigh(end.body, Vec6(end.W->col(k)));
    return A;
}

MatX JointSolver::geometric_transpose() const {
    return transpose([&](std::size_t body, Vec6 wrench) {
        if (length_[body] > 0) wrench.tail<3>() /= length_[body];
        return wrench;
    });
}

/// Of M^{-1/2} C^T in the kept rows.
Real JointSolver::condition() const {
    std::vector<Mat3> roots;
    for (const BodyNode& node : nodes_) roots.push_back(node.J.llt().matrixL());
    const MatX A = transpose([&](std::size_t body, Vec6 wrench) {
        wrench.head<3>() *= sqrt(nodes_[body].inverse_mass);
        roots[body].triangularView<Eigen::Lower>().solveInPlace(wrench.tail<3>());
        return wrench;
    });
    MatX independent(A.rows(), choice_.rank);
    Eigen::Index column = 0;
    for (Eigen::Index i = 0; i < A.cols(); ++i)
        if (kept(i)) independent.col(column++) = A.col(i);
    return pivot_ratio(independent);
}

void JointSolver::evaluate_rows(const Real& t) {
    const Motion rest;
    const std::vector<Joint>& joints = model_.joints;
    for (std::size_t j = 0; j < rows_.size(); ++j) {
        const auto of = [&](int body) -> const Motion& {
            return body == ground ? rest : nodes_[static_cast<std::size_t>(body)].motion;
        };
        write_rows(joints[j], t, of(joints[j].first), of(joints[j].second), rows_[j]);
    }
}

void JointSolver::assemble() {
    for (End& end : ends_) {
        const BodyNode& node = nodes_[end.body];
        for (int k = 0; k < matrix_.rows[end.joint]; ++k) end.mobility.col(k) = node.mobility(end.W->col(k));
    }
    for (Mat6& block : matrix_.diagonal) block.setZero();
    for (Mat6& block : matrix_.lower) block.setZero();
    for (const EndPair& pair : pairs_) {
        const End &a = ends_[pair.row_end], &b = ends_[pair.col_end];
        const int rows = matrix_.rows[a.joint], cols = matrix_.rows[b.joint];
        Mat6& block = pair.diagonal ? matrix_.diagonal[pair.block] : matrix_.lower[pair.block];
        block.topLeftCorner(rows, cols) += a.W->leftCols(rows).transpose().lazyProduct(b.mobility.leftCols(cols));
    }
}

/// Inserts unit rows for dropped rows, and factors.
Real JointSolver::factor() {
    assemble();
    if (!complete_) {
        const auto left_out = [&](std::size_t joint, int k) { return k < matrix_.rows[joint] && !kept(at(joint, k)); };
        for (std::size_t j = 0; j < rows_.size(); ++j)
            for (int k = 0; k < most_rows; ++k) {
                if (!left_out(j, k)) continue;
                matrix_.diagonal[j].row(k).setZero(), matrix_.diagonal[j].col(k).setZero();
                matrix_.diagonal[j](k, k) = 1;
            }
        for (std::size_t e = 0; e < matrix_.entries.size(); ++e) {
            const auto row = static_cast<std::size_t>(matrix_.entries[e].row),
                       col = static_cast<std::size_t>(matrix_.entries[e].col);
            for (int k = 0; k < most_rows; ++k) {
                if (left_out(row, k)) matrix_.lower[e].row(k).setZero();
                if (left_out(col, k)) matrix_.lower[e].col(k).setZero();
            }
        }
    }
    return solver_->factor(matrix_);
}

/// As many rows as before: the most independent ones at the present configuration.
Status JointSolver::choose_again() {
    const MatX A = geometric_transpose();
    if (!A.allFinite()) return Status::non_finite;
    const RowChoice fresh = choose_rows(A, choice_.rank);
    if (fresh.rank < choice_.rank) {
        singularity_ = "rank " + std::to_string(fresh.rank) + " of the constraints, " + std::to_string(choice_.rank) +
                       " at the start; dependent: " + name_rows(fresh.independent, false);
        return Status::singular_kkt;
    }
    choice_ = fresh;
    complete_ = choice_.rank == matrix_.size;
    pivot_ = factor();
    if (pivot_ > 0) return Status::ok;  // nearly dependent rows are used
    singularity_ = "the masses differ so much that the rows kept cannot be told apart in this precision";
    return isfinite(pivot_) ? Status::singular_kkt : Status::non_finite;
}

void JointSolver::evaluate_residual(bool all_rows) {
    residual_ = bias_;
    for (const End& end : ends_) {
        const int n = matrix_.rows[end.joint];
        residual_.segment(matrix_.offset[end.joint], n) +=
            end.W->leftCols(n).transpose().lazyProduct(nodes_[end.body].a);
    }
    if (complete_ || all_rows) return;
    for (Eigen::Index i = 0; i < residual_.size(); ++i)
        if (!kept(i)) residual_[i] = 0;
}

void JointSolver::apply(const VecX& lambda) {
    for (const End& end : ends_) {
        const int n = matrix_.rows[end.joint];
        nodes_[end.body].a -= end.mobility.leftCols(n).lazyProduct(lambda.segment(matrix_.offset[end.joint], n));
    }
}

void JointSolver::add_terms(bool bias) {
    for (const End& end : ends_) {
        const BodyNode& node = nodes_[end.body];
        const Real linear = node.a.head<3>().norm(), angular = node.a.tail<3>().norm();
        for (int k = 0; k < matrix_.rows[end.joint]; ++k) {
            const Eigen::Index row = at(end.joint, k);
            sizes_[row] += end.W->col(k).head<3>().norm() * linear + end.W->col(k).tail<3>().norm() * angular;
            if (bias) sizes_[row] += spin_term_share * scale_[row] * node.motion.omega.squaredNorm();
        }
    }
    if (bias) sizes_ += bias_.cwiseAbs();
}

void JointSolver::compare_terms() {
    std::fill(largest_.begin(), largest_.end(), Real(0));
    for (std::size_t j = 0; j < rows_.size(); ++j)
        for (int k = 0; k < matrix_.rows[j]; ++k)
            largest_[island_[j]] = max(largest_[island_[j]], Real(sizes_[at(j, k)] / scale_[at(j, k)]));
    // In a mechanism at rest beside a moving one, velocities are round-off of that motion.
    Real all = *std::max_element(largest_.begin(), largest_.end());
    for (const BodyNode& node : nodes_) all = max(all, Real(node.motion.omega.squaredNorm()));
    for (Real& largest : largest_) largest = max(largest, Real(epsilon * all));
}

bool JointSolver::hold(bool those_kept, const Real& share, const char* what) {
    const auto is_beyond = [&](std::size_t joint, int k) {
        const Eigen::Index row = at(joint, k);
        return kept(row) == those_kept && abs(residual_[row]) > share * scale_[row] * largest_[island_[joint]];
    };
    std::string names;
    for (std::size_t j = 0; j < rows_.size(); ++j)
        for (int k = 0; k < matrix_.rows[j]; ++k)
            if (is_beyond(j, k)) names += (names.empty() ? "" : ", ") + name_row(j, k);
    if (!names.empty()) singularity_ = what + names;
    return names.empty();
}

bool JointSolver::left_out_rows_hold() {
    evaluate_residual(true);
    return hold(false, dropped_row_rel_tol, "rows that followed from others at the start are violated: ");
}

bool JointSolver::refine() {
    evaluate_residual(false);
    correction_ = residual_;
    solver_->solve(correction_);
    lambda_ += correction_;
    apply(correction_);
    evaluate_residual(false);
    add_terms(false);
    compare_terms();
    return hold(true, kept_row_rel_tol,
                "rows that depend on each other but for round-off, by position or by the masses, are not met: ");
}

Status JointSolver::choose_and_factor() {
    if (rows_.empty()) return Status::ok;
    pivot_ = factor();
    if (!isfinite(pivot_)) return Status::non_finite;
    least_pivot_ = min(least_pivot_, pivot_);
    doubtful_ = pivot_ <= doubtful_pivot;
    return doubtful_ ? choose_again() : Status::ok;
}

Status JointSolver::prepare(const Real& t) {
    evaluate_rows(t);
    return choose_and_factor();
}

Status JointSolver::react(bool watch) {
    if (rows_.empty()) return Status::ok;
    bias_ = residual_;
    evaluate_residual(false);
    watch = watch && !complete_;
    if (watch || doubtful_) sizes_.setZero(), add_terms(true), compare_terms();
    lambda_ = residual_;
    solver_->solve(lambda_);
    apply(lambda_);
    if (watch && !left_out_rows_hold()) return Status::singular_kkt;
    return !doubtful_ || refine() ? Status::ok : Status::singular_kkt;
}

/// lambda -= P lambda in rows divided by their scale, P = U U^T the projector onto the null vectors of C^T, which are
/// (S^{-1} S_k, -1) for each dropped row k. The norm of a row of U measures how far that row is from unique.
void JointSolver::minimise_norm(VecX& lambda) {
    if (complete_) return;
    std::vector<Eigen::Index> left_out;
    for (Eigen::Index i = 0; i < matrix_.size; ++i)
        if (!kept(i)) left_out.push_back(i);
    MatX N(matrix_.size, static_cast<Eigen::Index>(left_out.size()));
    for (Eigen::Index c = 0; c < N.cols(); ++c) {
        const Eigen::Index row = left_out[static_cast<std::size_t>(c)];
        VecX unit = VecX::Zero(matrix_.size), column = unit;
        unit[row] = 1;
        std::vector<Vec6> a(nodes_.size(), Vec6::Zero());
        for (const End& end : ends_) {
            const int n = matrix_.rows[end.joint];
            a[end.body] += end.mobility.leftCols(n) * unit.segment(matrix_.offset[end.joint], n);
        }
        for (const End& end : ends_) {
            const int n = matrix_.rows[end.joint];
            column.segment(matrix_.offset[end.joint], n) += end.W->leftCols(n).transpose() * a[end.body];
        }
        for (const Eigen::Index i : left_out) column[i] = 0;
        solver_->solve(column);
        N.col(c) = scale_.asDiagonal() * (column - unit) / scale_[row];  // free of units
    }
    const Eigen::HouseholderQR<MatX> factors(N);
    const MatX U = factors.householderQ() * MatX::Identity(N.rows(), N.cols());
    share_ = U.rowwise().norm();
    const VecX scaled = scale_.asDiagonal() * lambda;
    lambda -= scale_.cwiseInverse().asDiagonal() * (U * (U.transpose() * scaled));
}

const VecX& JointSolver::multipliers() {
    minimise_norm(lambda_);
    return lambda_;
}

Status JointSolver::accelerate(const Real& t, const Turns& turns, const Real* labels) {
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
    if (const Status status = prepare(t); status != Status::ok) return status;
    for (std::size_t j = 0; j < rows_.size(); ++j)
        residual_.segment(matrix_.offset[j], matrix_.rows[j]) = rows_[j].acceleration_bias.head(matrix_.rows[j]);
    return react(true);
}

Status JointSolver::constrain(const VecX& c) {
    residual_ = -c;
    return react(false);
}

std::string JointSolver::name_row(std::size_t joint, int k) const {
    return "row " + std::to_string(k + 1) + " of " + model_.name_of_joint(joint);
}

std::string JointSolver::name_rows(const std::vector<bool>& rows, bool which) const {
    std::string names;
    for (std::size_t j = 0; j < rows_.size(); ++j)
        for (int k = 0; k < matrix_.rows[j]; ++k)
            if (rows[static_cast<std::size_t>(at(j, k))] == which)
                names += (names.empty() ? "" : ", ") + name_row(j, k);
    return names;
}

std::string JointSolver::weakness() const {
    constexpr int weak = 1000;
    if (!(weak * pivot_ < 1)) return "";
    const MatX A = geometric_transpose();
    if (!A.allFinite()) return "";
    const RowChoice others = choose_rows(A, choice_.rank - 1);
    std::string names;
    for (std::size_t j = 0; j < rows_.size(); ++j)
        for (int k = 0; k < matrix_.rows[j]; ++k)
            if (kept(at(j, k)) && !others.independent[static_cast<std::size_t>(at(j, k))])
                names += (names.empty() ? "" : ", ") + name_row(j, k);
    return "close to a pose in which the constraints lose rank: " + names + " all but follow from the others";
}

ConstraintRank JointSolver::constraint_rank() const {
    ConstraintRank rank{matrix_.size, choice_.rank, {}, condition_};
    for (std::size_t j = 0; j < rows_.size(); ++j)
        for (int k = 0; k < matrix_.rows[j]; ++k)
            if (!kept(at(j, k))) rank.redundant.push_back(name_row(j, k));
    return rank;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
