// SPDX-License-Identifier: BSD-3-Clause
//
// The Taylor series in time of a model's motion, straight from its bodies, joints, gravity and loads. For each body, with
// R in R^{3x3} (nothing orthonormalises it) and the sum over the joint ends e on it (sign s = 1 at the first body of
// a joint, -1 at the second; point r in body axes),
//   x' = v,   R' = R hat(omega),   m v' = m g(t) + f - sum s lambda,   J omega' = tau - omega x J omega - sum s r x R^T lambda,
// with the loads' force f in space axes and torque tau in body axes, and
//   sum over the two ends of a joint of s (v' + R (omega' x r + omega x (omega x r))) = 0.
// Products of series are Cauchy products, so coefficient k of (v', omega', lambda) solves a linear system whose matrix,
// S = C M^{-1} C^T at the expansion point, is the same for every k: it is factored once [hairer1993, Sec. I.8]. Steps end
// where the last terms sink into round-off [jorbazou2005].
#pragma once

#include <Eigen/LU>
#include <vector>

#include "lie/status.hpp"
#include "mechanics/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// One object per thread: it owns its work space.
class TaylorSeries {
  public:
    /// Throws std::invalid_argument for an order below 2.
    TaylorSeries(const Model& model, int order);

    /// The series of the motion that passes through `states` at time t (s).
    Status expand(const Real& t, const std::vector<BodyState>& states);

    /// The largest s = limit, 7/8 limit, ... for which the last two terms of x, R, v and omega (each over all bodies)
    /// are below round-off of their largest terms; negative for a negative limit.
    Real reach(const Real& limit) const;
    /// The states at a time s after that of the expansion; |s| within reach.
    std::vector<BodyState> states(const Real& s) const;
    /// At the time of the expansion: lambda (N), rows in space axes, joints in the order of the model.
    std::vector<Real> multipliers() const;

  private:
    using Vectors = std::vector<Vec3>;
    struct BodySeries {
        Vectors x, v, omega, momentum;  // momentum: J omega
        std::vector<Mat3> R;
        Mat3 inverse_inertia;
        Vec3 torque;  // coefficient k of J omega', without that of lambda
        Vec3 free;    // coefficient k of v', without that of lambda
    };
    /// Where a joint holds a moving body: its body-axis acceleration p = omega' x r + omega x (omega x r).
    struct End {
        std::size_t body, joint;
        Real sign;
        Vec3 r;
        Vectors velocity, p;  // velocity: omega x r
        Vec3 known;           // coefficient k of R p, without that of omega'
    };

    bool factor();
    void prepare_body(BodySeries& body, std::size_t k) const;
    void prepare_end(End& end, std::size_t k);
    void add_load(const Load& load, const Real& t, std::size_t k);
    void solve(std::size_t k);
    void raise(BodySeries& body, std::size_t k) const;
    Vec3 gravity(const Real& t, std::size_t k) const;

    Model model_;
    std::size_t order_;
    std::vector<BodySeries> bodies_;
    std::vector<End> ends_;
    std::vector<Vectors> lambda_;  // of each joint
    MatX schur_;
    VecX rhs_, solution_;
    Eigen::FullPivLU<MatX> factors_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
