// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/joint_solver.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <map>

#include "mechanics/forces.hpp"
#include "mechanics/forest.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Pivots of S are squares of those of M^{-1/2} C^T: below this the rows kept are chosen anew.
const Real doubtful_pivot = Real(1) / 10000000000;
/// By this share of its terms a row that was left out may be violated by accelerations: drift does so a little. Where all
/// terms vanish, 1e-9 of the row's scale (per s^2) counts as nothing.
const Real noticeable = Real(1) / 1000, nothing = Real(1) / 1000000000;

}  // namespace

JointSolver::JointSolver(const Model& model, SolverChoice choice) : model_(model), rows_(model.joints.size()) {
    for (const Body& body : model_.bodies) nodes_.push_back({inverse_mass(body), body.J, body.J.inverse(), {}});
    connect();
    solver_ = make_solver(matrix_, choice);
    residual_ = lambda_ = sizes_ = bias_ = VecX::Zero(matrix_.size);
    scale_.resize(matrix_.size);
    for (std::size_t j = 0; j < rows_.size(); ++j)
        for (int k = 0; k < matrix_.rows[j]; ++k)
            scale_[at(j, k)] = row_scale(model_.joints[j], k);
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
    if (rows > few && is_forest(model_))
        choice_ = {std::vector<bool>(static_cast<std::size_t>(rows), true), rows, {}};
    else
        choice_ = choose_rows(weighted_transpose(), rows);
    complete_ = choice_.rank == rows;
}

MatX JointSolver::weighted_transpose() const {
    MatX A = MatX::Zero(6 * static_cast<Eigen::Index>(nodes_.size()), matrix_.size);
    for (const End& end : ends_) {
        const Body& body = model_.bodies[end.body];
        const Mat3 L = body.J.llt().matrixL();
        const Eigen::Index i = 6 * static_cast<Eigen::Index>(end.body);
        for (int k = 0; k < matrix_.rows[end.joint]; ++k) {
            const auto column = at(end.joint, k);
            A.block<3, 1>(i, column) += end.W->block<3, 1>(0, k) / sqrt(body.mass);
            A.block<3, 1>(i + 3, column) +=
                L.triangularView<Eigen::Lower>().solve(end.W->block<3, 1>(3, k));
        }
    }
    return A;
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
    for (const Pair& pair : pairs_) {
        const End &a = ends_[pair.row_end], &b = ends_[pair.col_end];
        const int rows = matrix_.rows[a.joint], cols = matrix_.rows[b.joint];
        Mat6& block = pair.diagonal ? matrix_.diagonal[pair.block] : matrix_.lower[pair.block];
        block.topLeftCorner(rows, cols) += a.W->leftCols(rows).transpose().lazyProduct(b.mobility.leftCols(cols));
    }
}

/// Puts unit rows where a row is left out, and factors.
Status JointSolver::factor() {
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
            const auto row = static_cast<std::size_t>(matrix_.entries[e].row), col = static_cast<std::size_t>(matrix_.entries[e].col);
            for (int k = 0; k < most_rows; ++k) {
                if (left_out(row, k)) matrix_.lower[e].row(k).setZero();
                if (left_out(col, k)) matrix_.lower[e].col(k).setZero();
            }
        }
    }
    const Real pivot = solver_->factor(matrix_);
    if (pivot > doubtful_pivot) return Status::ok;
    return isfinite(pivot) ? Status::singular_kkt : Status::non_finite;
}

/// As many rows as before, those that are most independent at the present configuration.
Status JointSolver::choose_again() {
    const MatX A = weighted_transpose();
    if (!A.allFinite()) return Status::non_finite;
    const RowChoice fresh = choose_rows(A, choice_.rank);
    if (fresh.rank < choice_.rank) {
        singularity_ = "rank " + std::to_string(fresh.rank) + " of the constraints, " + std::to_string(choice_.rank) +
                       " at the start; dependent: " + name_rows(fresh.independent, false);
        return Status::singular_kkt;
    }
    choice_ = fresh;
    complete_ = choice_.rank == matrix_.size;
    const Status status = factor();
    // Doubtful but independent rows are solved with; a pivot that is not positive cannot be.
    return status == Status::singular_kkt && solver_->factor(matrix_) > 0 ? Status::ok : status;
}

Status JointSolver::react(bool watch) {
    if (rows_.empty()) return Status::ok;
    Status status = factor();
    if (status == Status::singular_kkt) status = choose_again();
    if (status != Status::ok) return status;
    bias_ = residual_;
    for (const End& end : ends_) {
        const int n = matrix_.rows[end.joint];
        residual_.segment(matrix_.offset[end.joint], n) +=
            end.W->leftCols(n).transpose().lazyProduct(nodes_[end.body].a);
    }
    sizes_ = residual_.cwiseAbs() + bias_.cwiseAbs();
    if (!complete_)
        for (Eigen::Index i = 0; i < residual_.size(); ++i)
            if (!kept(i)) residual_[i] = 0;
    lambda_ = residual_;
    solver_->solve(lambda_);
    for (const End& end : ends_) {
        const int n = matrix_.rows[end.joint];
        nodes_[end.body].a -= end.mobility.leftCols(n).lazyProduct(lambda_.segment(matrix_.offset[end.joint], n));
    }
    return watch && !complete_ && !left_out_rows_hold() ? Status::singular_kkt : Status::ok;
}

bool JointSolver::left_out_rows_hold() {
    residual_ = bias_;
    for (const End& end : ends_) {
        const int n = matrix_.rows[end.joint];
        residual_.segment(matrix_.offset[end.joint], n) +=
            end.W->leftCols(n).transpose().lazyProduct(nodes_[end.body].a);
    }
    std::vector<bool> violated(static_cast<std::size_t>(residual_.size()), false);
    bool hold = true;
    const Real largest = sizes_.maxCoeff();
    for (std::size_t i = 0; i < violated.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        violated[i] = !kept(k) && abs(residual_[k]) > noticeable * max(sizes_[k], largest) + nothing * scale_[k];
        hold = hold && !violated[i];
    }
    if (!hold) singularity_ = "rows that followed from others at the start are violated: " + name_rows(violated, true);
    return hold;
}

/// lambda -= N (N^T N)^{-1} N^T lambda in rows divided by their scale, where the columns of N are the null vectors of
/// C^T: (S^{-1} S_k, -1) for each row k left out.
void JointSolver::minimise_norm() {
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
        N.col(c) = scale_.asDiagonal() * (column - unit);
    }
    const VecX scaled = scale_.asDiagonal() * lambda_;
    const VecX shift = N * (N.transpose() * N).ldlt().solve(N.transpose() * scaled);
    lambda_ -= scale_.cwiseInverse().asDiagonal() * shift;
}

const VecX& JointSolver::multipliers() {
    if (!complete_) minimise_norm();
    return lambda_;
}

Status JointSolver::accelerate(const Real& t) {
    const Vec3 g = model_.gravity.at(t);
    for (BodyNode& node : nodes_) {
        const Vec3& w = node.motion.omega;
        node.a << node.motion.R.transpose() * g, node.J_inverse * (node.J * w).cross(w);
    }
    const Motion rest;
    for_each_wrench(model_, t,
                    [&](int body) -> const Motion& {
                        return body == ground ? rest : nodes_[static_cast<std::size_t>(body)].motion;
                    },
                    [&](int body, const Wrench& wrench) {
                        Vec6 both;
                        both << wrench.force, wrench.torque;
                        BodyNode& node = nodes_[static_cast<std::size_t>(body)];
                        node.a += node.mobility(both);
                    });
    evaluate_rows(t);
    for (std::size_t j = 0; j < rows_.size(); ++j)
        residual_.segment(matrix_.offset[j], matrix_.rows[j]) = rows_[j].acceleration_bias.head(matrix_.rows[j]);
    return react(true);
}

Status JointSolver::constrain(const Real& t, const VecX& c) {
    evaluate_rows(t);
    residual_ = -c;
    return react(false);
}

std::string JointSolver::name_rows(const std::vector<bool>& rows, bool which) const {
    std::string names;
    for (std::size_t j = 0; j < rows_.size(); ++j)
        for (int k = 0; k < matrix_.rows[j]; ++k)
            if (rows[static_cast<std::size_t>(at(j, k))] == which)
                names += (names.empty() ? "row " : ", row ") + std::to_string(k + 1) + " of " + model_.name_of_joint(j);
    return names;
}

ConstraintRank JointSolver::constraint_rank() const {
    ConstraintRank rank{matrix_.size, choice_.rank, {}, choice_.condition};
    for (std::size_t j = 0; j < rows_.size(); ++j)
        for (int k = 0; k < matrix_.rows[j]; ++k)
            if (!kept(at(j, k)))
                rank.redundant.push_back("row " + std::to_string(k + 1) + " of " + model_.name_of_joint(j));
    return rank;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
