// SPDX-License-Identifier: BSD-3-Clause
//
// A body as power series in time. With R in R^{3x3} (never orthonormalised), the force f and the moment n about
// the mass centre, both in space axes,
//   x' = v,   R' = R hat(omega),   m v' = f,   J omega' = R^T n - omega x J omega.
#pragma once

#include "engine/reference/taylor/power_series.hpp"
#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Series of a body, or of the ground, which has only coefficient 0. At stage k the coefficients up to k of v and
/// omega and up to k + 1 of x and R are known; forces act, and `advance` gives one more of each, and one more again of
/// x and R.
class BodySeries {
  public:
    /// All series have `size` coefficients.
    BodySeries(const Body& body, std::size_t size);
    static BodySeries fixed(std::size_t size);

    /// Stage 0: coefficients 0 of all, and 1 of x and R.
    void start(const BodyState& state);
    /// Before forces act at stage k.
    void begin(std::size_t k);
    /// Coefficient k of a force and of a moment.
    void act(const Vec3& f, const Vec3& n, std::size_t k) {
        force[k] += f, moment[k] += n;
        turned_ = turned_ || (n.array() != 0).any();
        if (k == 0) notice(f, n);
    }
    /// Adds the size of one term of the acceleration.
    void notice(const Vec3& f, const Vec3& n) { force_size_ += f.norm(), moment_size_ += n.norm(); }
    /// Sums of the sizes of all forces over the mass and of all moments times |J^{-1}|: where these cancel, as in a
    /// body held at rest, velocities are round-off of them.
    Real acceleration_size() const { return force_size_ / mass_; }
    Real turning_size() const { return moment_size_ * inverse_inertia_.norm(); }
    /// v_{k+1}, omega_{k+1}, x_{k+2} and R_{k+2} from force_k and moment_k.
    void advance(std::size_t k);
    /// The same for a force and a moment that act on top of those.
    void correct(const Vec3& f, const Vec3& n, std::size_t k);
    bool is_fixed() const { return fixed_; }
    /// Radius of gyration (m), 0 of a point mass.
    const Real& radius() const { return radius_; }
    /// M^{-1/2} times a force and a moment in space axes, at the expansion point.
    Eigen::Matrix<Real, 6, 1> weighted(const Vec3& f, const Vec3& n) const;

    Vectors x, v, omega, force, moment;
    Series<Mat3> R;

  private:
    explicit BodySeries(std::size_t size);

    Real mass_ = 1, radius_ = 0;
    Mat3 J_ = Mat3::Identity(), inverse_inertia_ = Mat3::Identity(), inverse_root_ = Mat3::Identity();
    Vectors momentum_;  // J omega
    Real force_size_ = 0, moment_size_ = 0;
    bool fixed_ = true, turned_ = false;  // turned_: a moment has acted since the start
};

/// A vector fixed in a body (body axes), in space axes: R b.
class Attached {
  public:
    Attached(const BodySeries& body, const Vec3& b) : body_(&body), b_(b), series_(body.R.size(), Vec3::Zero()) {}
    void update(std::size_t i) { series_[i] = body_->R[i] * b_; }
    const Vectors& series() const { return series_; }
    const Vec3& operator[](std::size_t i) const { return series_[i]; }

  private:
    const BodySeries* body_;
    Vec3 b_;
    Vectors series_;
};

/// As many coefficients as the body has.
inline Vectors vectors(const BodySeries& body) { return Vectors(body.R.size(), Vec3::Zero()); }
inline Scalars scalars(const BodySeries& body) { return Scalars(body.R.size(), Real(0)); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
