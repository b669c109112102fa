// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/schur.hpp"

#include <Eigen/LU>
#include <map>

#include "mechanics/elimination.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// How one joint touches one body: its sign, the point, and whether rows must be turned by the relative rotation.
struct Touch {
    int joint, sign;
    bool turned;
    Vec3 r;
};

std::vector<std::vector<Touch>> touches_by_body(const Model& model) {
    std::vector<std::vector<Touch>> touches(model.bodies.size());
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
        const Joint& joint = model.joints[j];
        const int index = static_cast<int>(j);
        if (joint.first != ground)
            touches[static_cast<std::size_t>(joint.first)].push_back({index, 1, true, joint.r_first});
        touches[static_cast<std::size_t>(joint.second)].push_back({index, -1, false, joint.r_second});
    }
    return touches;
}

std::vector<std::set<int>> joint_graph(const std::vector<std::vector<Touch>>& touches, std::size_t joints) {
    std::vector<std::set<int>> adjacent(joints);
    for (const auto& body : touches)
        for (const Touch& a : body)
            for (const Touch& b : body)
                if (a.joint != b.joint) adjacent[static_cast<std::size_t>(a.joint)].insert(b.joint);
    return adjacent;
}

/// Inverse of a symmetric positive definite 3x3 pivot by cofactors. False if its least eigenvalue, which
/// det S / (tr S)^2 bounds from below up to a factor of 4, is round-off of `size`, the trace before elimination: a
/// dependent row leaves round-off there, never exactly zero, and the inverse alone is blind to that.
bool invert_pivot(const Mat3& pivot, const Real& size, Mat3& inverse) {
    const Real unit = 1 / size;
    const Mat3 S = unit * pivot;  // free of units: products of three entries neither overflow nor vanish
    const Vec3 c0 = S.col(1).cross(S.col(2)), c1 = S.col(2).cross(S.col(0)), c2 = S.col(0).cross(S.col(1));
    const Real determinant = S.col(0).dot(c0), trace = S.trace(), factor = unit / determinant;
    inverse.row(0) = factor * c0;
    inverse.row(1) = factor * c1;
    inverse.row(2) = factor * c2;
    return determinant > 64 * epsilon * trace * trace;
}

}  // namespace

SchurComplement::SchurComplement(const Model& model) {
    const std::size_t joints = model.joints.size();
    const auto touches = touches_by_body(model);
    Elimination elimination = eliminate(joint_graph(touches, joints));
    joint_at_ = elimination.order;
    std::map<std::pair<int, int>, int> block;
    for (std::size_t k = 0; k < joints; ++k) block[{k, k}] = static_cast<int>(k);
    columns_.resize(joints);
    for (std::size_t k = 0; k < joints; ++k)
        for (const int row : elimination.neighbours[k]) {
            const int next = static_cast<int>(block.size());
            block[{row, static_cast<int>(k)}] = next;
            columns_[k].push_back({row, next});
        }
    updates_.resize(joints);
    for (std::size_t k = 0; k < joints; ++k)
        for (const Entry& right : columns_[k])
            for (const Entry& left : columns_[k])
                if (left.row >= right.row) updates_[k].push_back({block.at({left.row, right.row}), left.block, right.block});

    constant_.assign(block.size(), Mat3::Zero());
    for (std::size_t i = 0; i < touches.size(); ++i) {
        const Body& body = model.bodies[i];
        const Mat3 J_inverse = body.J.inverse();
        for (const Touch& a : touches[i])
            for (const Touch& b : touches[i]) {
                const int row = elimination.position[static_cast<std::size_t>(a.joint)];
                const int col = elimination.position[static_cast<std::size_t>(b.joint)];
                if (row < col) continue;
                const Mat3 K = Real(a.sign * b.sign) *
                               (Mat3::Identity() / body.mass - hat(a.r) * J_inverse * hat(b.r));
                const int slot = block.at({row, col});
                if (a.turned || b.turned)
                    moving_.push_back({slot, a.turned ? a.joint : -1, b.turned ? b.joint : -1, K});
                else
                    constant_[static_cast<std::size_t>(slot)] += K;
            }
    }
    blocks_ = scaled_ = constant_;
    inverse_pivots_.assign(joints, Mat3::Zero());
    sizes_.assign(joints, Real(0));
    rhs_.assign(joints, Vec3::Zero());
    if (is_constant()) status_ = factor_blocks();
}

Status SchurComplement::factor(const Mat3* relative) {
    blocks_ = constant_;
    for (const Term& term : moving_) {
        Mat3& block = blocks_[static_cast<std::size_t>(term.block)];
        if (term.row >= 0 && term.col >= 0)
            block += relative[term.row] * term.K * relative[term.col].transpose();
        else if (term.row >= 0)
            block += relative[term.row] * term.K;
        else
            block += term.K * relative[term.col].transpose();
    }
    return factor_blocks();
}

Status SchurComplement::factor_blocks() {
    for (std::size_t k = 0; k < columns_.size(); ++k) sizes_[k] = blocks_[k].trace();
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        if (!invert_pivot(blocks_[k], sizes_[k], inverse_pivots_[k])) {
            failed_ = k;
            return Status::singular_kkt;
        }
        for (const Entry& entry : columns_[k]) {
            const auto i = static_cast<std::size_t>(entry.block);
            scaled_[i] = blocks_[i] * inverse_pivots_[k];
        }
        for (const Update& update : updates_[k])
            blocks_[static_cast<std::size_t>(update.target)] -=
                scaled_[static_cast<std::size_t>(update.left)] * blocks_[static_cast<std::size_t>(update.right)].transpose();
    }
    return Status::ok;
}

std::string SchurComplement::singularity(const Model& model) const {
    if (!failed_) return "";
    return "the rows of " + model.name_of_joint(static_cast<std::size_t>(joint_at_[*failed_])) + " depend on those of others";
}

void SchurComplement::substitute(Vec3* b) const {
    const std::size_t n = columns_.size();
    for (std::size_t k = 0; k < n; ++k) rhs_[k] = b[joint_at_[k]];
    for (std::size_t k = 0; k < n; ++k)
        for (const Entry& entry : columns_[k])
            rhs_[static_cast<std::size_t>(entry.row)] -= scaled_[static_cast<std::size_t>(entry.block)] * rhs_[k];
    for (std::size_t k = n; k-- > 0;) {
        Vec3 x = inverse_pivots_[k] * rhs_[k];
        for (const Entry& entry : columns_[k])
            x -= scaled_[static_cast<std::size_t>(entry.block)].transpose() * rhs_[static_cast<std::size_t>(entry.row)];
        rhs_[k] = x;
        b[joint_at_[k]] = x;
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
