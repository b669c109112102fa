// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/row_terms.hpp"

#include <algorithm>

#include "mechanics/solve/forest.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Fraction of scale omega^2 that counts as a term where the terms themselves vanish. It is small because a body spins
/// fast about a symmetry axis without any acceleration: all of omega^2 would hide contradictory joints.
const Real spin_term_share = Real(1) / 10000;

}  // namespace

RowTerms::RowTerms(const Model& model, const ConstraintMatrix& C)
    : island_(islands(model)), largest_(model.bodies.size()), sizes_(VecX::Zero(C.size())), scale_(C.size()) {
    for (std::size_t j = 0; j < C.joints(); ++j)
        for (int k = 0; k < C.rows(j); ++k) scale_[C.at(j, k)] = row_scale(model, model.joints[j], k);
}

void RowTerms::add(const ConstraintMatrix& C, const std::vector<BodyNode>& bodies, bool spin) {
    for (const ConstraintMatrix::End& end : C.ends()) {
        const BodyNode& body = bodies[end.body];
        const Real linear = body.a.head<3>().norm(), angular = body.a.tail<3>().norm();
        for (int k = 0; k < C.rows(end.joint); ++k) {
            const Eigen::Index row = C.at(end.joint, k);
            sizes_[row] += end.W->col(k).head<3>().norm() * linear + end.W->col(k).tail<3>().norm() * angular;
            if (spin) sizes_[row] += spin_term_share * scale_[row] * body.motion.omega.squaredNorm();
        }
    }
}

void RowTerms::compare(const ConstraintMatrix& C, const std::vector<BodyNode>& bodies) {
    std::fill(largest_.begin(), largest_.end(), Real(0));
    for (std::size_t j = 0; j < C.joints(); ++j)
        for (int k = 0; k < C.rows(j); ++k)
            largest_[island_[j]] = max(largest_[island_[j]], Real(sizes_[C.at(j, k)] / scale_[C.at(j, k)]));
    // In a mechanism at rest beside a moving one, velocities are round-off of that motion.
    Real all = *std::max_element(largest_.begin(), largest_.end());
    for (const BodyNode& body : bodies) all = max(all, Real(body.motion.omega.squaredNorm()));
    for (Real& largest : largest_) largest = max(largest, Real(epsilon * all));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
