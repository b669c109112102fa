// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/taylor_bodies.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// (R hat(omega))_k.
Mat3 turn(const Series<Mat3>& R, const Vectors& omega, std::size_t k) {
    Mat3 sum = Mat3::Zero();
    for (std::size_t j = 0; j <= k; ++j)
        for (int i = 0; i < 3; ++i) {
            const Vec3 row = R[j].row(i);
            sum.row(i) += row.cross(omega[k - j]).transpose();
        }
    return sum;
}

}  // namespace

BodySeries::BodySeries(std::size_t size)
    : x(size, Vec3::Zero()), v(x), omega(x), force(x), moment(x), R(size, Mat3::Zero()), momentum_(x) {
    R[0].setIdentity();
}

BodySeries::BodySeries(const Body& body, std::size_t size) : BodySeries(size) {
    mass_ = body.mass, J_ = body.J, inverse_inertia_ = body.J.inverse(), fixed_ = false;
    if (!body.point) radius_ = sqrt(J_.trace() / (2 * mass_));
    const Mat3 L = body.J.llt().matrixL();
    inverse_root_ = L.inverse();
}

BodySeries BodySeries::fixed(std::size_t size) { return BodySeries(size); }

void BodySeries::start(const BodyState& state) {
    x[0] = state.x, R[0] = state.R, v[0] = state.v, omega[0] = state.omega;
    x[1] = v[0], R[1] = turn(R, omega, 0);
    turned_ = false, force_size_ = moment_size_ = 0;
}

void BodySeries::begin(std::size_t k) { force[k].setZero(), moment[k].setZero(); }

void BodySeries::advance(std::size_t k) {
    momentum_[k] = J_ * omega[k];
    Vec3 torque = -cross(omega, momentum_, k);
    if (turned_) torque += transposed_product(R, moment, k);
    v[k + 1] = force[k] / (mass_ * real(k + 1));
    omega[k + 1] = inverse_inertia_ * torque / real(k + 1);
    x[k + 2] = v[k + 1] / real(k + 2);
    R[k + 2] = turn(R, omega, k + 1) / real(k + 2);
}

void BodySeries::correct(const Vec3& f, const Vec3& n, std::size_t k) {
    force[k] += f, moment[k] += n, turned_ = true;
    const Vec3 more_v = f / (mass_ * real(k + 1));
    const Vec3 more_omega = inverse_inertia_ * (R[0].transpose() * n) / real(k + 1);
    v[k + 1] += more_v, omega[k + 1] += more_omega;
    x[k + 2] += more_v / real(k + 2), R[k + 2] += R[0] * hat(more_omega) / real(k + 2);
}

Eigen::Matrix<Real, 6, 1> BodySeries::weighted(const Vec3& f, const Vec3& n) const {
    Eigen::Matrix<Real, 6, 1> column;
    column << f / sqrt(mass_), inverse_root_ * (R[0].transpose() * n);
    return column;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
