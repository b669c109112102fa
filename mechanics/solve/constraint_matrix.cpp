// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/constraint_matrix.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

ConstraintMatrix::ConstraintMatrix(const Model& model) : model_(model), rows_(model.joints.size()) {
    for (std::size_t j = 0; j < rows_.size(); ++j) {
        const Joint& joint = model_.joints[j];
        count_.push_back(rows_of(joint.type)), first_.push_back(size_);
        size_ += count_.back();
        if (joint.first != ground) ends_.push_back({j, static_cast<std::size_t>(joint.first), &rows_[j].first});
        if (joint.second != ground) ends_.push_back({j, static_cast<std::size_t>(joint.second), &rows_[j].second});
    }
}

std::string ConstraintMatrix::name_of_row(std::size_t joint, int k) const {
    return "row " + std::to_string(k + 1) + " of " + model_.name_of_joint(joint);
}

void ConstraintMatrix::evaluate(const Real& t, const std::vector<BodyNode>& bodies) {
    const Motion rest;
    const auto motion_of = [&](int body) -> const Motion& {
        return body == ground ? rest : bodies[static_cast<std::size_t>(body)].motion;
    };
    for (std::size_t j = 0; j < rows_.size(); ++j) {
        const Joint& joint = model_.joints[j];
        write_rows(joint, t, motion_of(joint.first), motion_of(joint.second), rows_[j]);
    }
}

void ConstraintMatrix::evaluate_mobilities(const std::vector<BodyNode>& bodies) {
    for (End& end : ends_) {
        const BodyNode& body = bodies[end.body];
        for (int k = 0; k < rows(end.joint); ++k) end.mobility.col(k) = body.mobility(end.W->col(k));
    }
}

void ConstraintMatrix::apply(const std::vector<BodyNode>& bodies, VecX& product) const {
    for (const End& end : ends_) {
        const int n = rows(end.joint);
        product.segment(at(end.joint, 0), n) += end.W->leftCols(n).transpose().lazyProduct(bodies[end.body].a);
    }
}

void ConstraintMatrix::subtract_reaction(const VecX& lambda, std::vector<BodyNode>& bodies) const {
    for (const End& end : ends_) {
        const int n = rows(end.joint);
        bodies[end.body].a -= end.mobility.leftCols(n).lazyProduct(lambda.segment(at(end.joint, 0), n));
    }
}

void ConstraintMatrix::acceleration_bias(VecX& bias) const {
    for (std::size_t j = 0; j < rows_.size(); ++j)
        bias.segment(first_[j], count_[j]) = rows_[j].acceleration_bias.head(count_[j]);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
