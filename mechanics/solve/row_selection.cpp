// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/row_selection.hpp"

#include <Eigen/Cholesky>

#include "mechanics/model/scales.hpp"
#include "mechanics/solve/forest.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Above this, a joint graph without cycles is taken at its word.
constexpr int many_rows = 200;

/// Of M^{-1/2} C^T in the rows of the choice.
Real condition_of(const ConstraintMatrix& C, const std::vector<BodyNode>& bodies, const RowChoice& choice) {
    std::vector<Mat3> roots;
    for (const BodyNode& body : bodies) roots.push_back(body.J.llt().matrixL());
    const MatX A = C.transpose([&](std::size_t body, Vec6 wrench) {
        wrench.head<3>() *= sqrt(bodies[body].inverse_mass);
        roots[body].triangularView<Eigen::Lower>().solveInPlace(wrench.tail<3>());
        return wrench;
    });
    MatX independent(A.rows(), choice.rank);
    Eigen::Index column = 0;
    for (Eigen::Index i = 0; i < A.cols(); ++i)
        if (choice.independent[static_cast<std::size_t>(i)]) independent.col(column++) = A.col(i);
    return pivot_ratio(independent);
}

}  // namespace

RowSelection::RowSelection(const Model& model, const ConstraintMatrix& C, const std::vector<BodyNode>& bodies)
    : length_(body_lengths(model)) {
    const int rows = C.size();
    if (rows > many_rows && is_forest(model)) {
        choice_ = {std::vector<bool>(static_cast<std::size_t>(rows), true), rows};
    } else {
        choice_ = choose_rows(geometric_transpose(C), rows);
        if (choice_.rank > 0 && rows <= 2 * many_rows)
            if (const Real ratio = condition_of(C, bodies, choice_); isfinite(ratio)) condition_ = ratio;
    }
    complete_ = choice_.rank == rows;
}

/// Torques over a length of their body: independent of units, masses and place.
MatX RowSelection::geometric_transpose(const ConstraintMatrix& C) const {
    return C.transpose([&](std::size_t body, Vec6 wrench) {
        if (length_[body] > 0) wrench.tail<3>() /= length_[body];
        return wrench;
    });
}

std::optional<RowChoice> RowSelection::best(const ConstraintMatrix& C, int rank) const {
    const MatX A = geometric_transpose(C);
    if (!A.allFinite()) return {};
    return choose_rows(A, rank);
}

void RowSelection::set(const RowChoice& choice) {
    choice_ = choice;
    complete_ = choice_.rank == static_cast<int>(choice_.independent.size());
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
