// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/newton/newton_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Each direction s takes from rest_, what is left of r, its part along J s.
Status NewtonStep::find(WeightedEquations& equations, const VecX& x, const VecX& r, const Real& distance,
                        InverseJacobian& H, Directions& directions, VecX& g) {
    rest_ = r;
    step_.setZero();
    directions.clear();
    Eigen::Index spare = -1;  // the coordinates are taken one after another where the residuals tell no more
    for (Eigen::Index i = 0; i < 3 * directions.most() && 64 * rest_.norm() > step_.norm(); ++i) {
        VecX& s = g;
        spare < 0 ? H.apply(rest_, s) : void(s = VecX::Unit(s.size(), spare++));
        if (const Status status = multiply_jacobian(equations, x, r, s, distance); status != Status::ok) return status;
        moved_ = p_;
        const Real length = directions.add(p_, 256, directions.most());
        if (!(length > 0)) {  // nothing new
            if (spare < 0 && directions.most() == s.size()) spare = 0;
            if (spare < 0 || spare == s.size()) break;
            continue;
        }
        H.apply(moved_, u_);
        u_ = (s - u_) / length;
        H.add(u_, p_, directions.most());  // now H J s = s
        const Real part = p_.dot(rest_);
        rest_ -= part * p_;
        H.apply(p_, g);
        step_ += part * g;
    }
    H.apply(rest_, g);
    g += step_;
    return Status::ok;
}

Status NewtonStep::multiply_jacobian(WeightedEquations& equations, const VecX& x, const VecX& r, const VecX& s,
                                     const Real& distance) {
    constexpr int steep = 256;  // the Jacobian is near the identity where nothing is stiff
    if (const Status status = equations.difference(x, r, s, distance, p_); status != Status::ok) return status;
    const Real steepness = largest_entry(p_) / largest_entry(s);
    if (steepness > steep)  // its curvature must not hide what is flat
        if (const Status status = equations.difference(x, r, s, distance / steepness, p_); status != Status::ok)
            return status;
    gain_ = max(gain_, Real(largest_entry(p_) / largest_entry(s)));
    return Status::ok;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
