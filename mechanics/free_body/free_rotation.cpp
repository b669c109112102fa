// SPDX-License-Identifier: BSD-3-Clause
//
// Momentum m in principal axes 1, 2, 3, axis 2 that of the middle moment, with A, B, C > 0:
//   m(t) = (A dn u, -B sn u, C cn u),   u = lambda t - nu.
// This is case (i) of [celledonifasso2008], momentum circling about axis 1. Their case (ii), circling about axis 3, is
// the same motion with the axes renamed (3, -2, 1); signs other than m1, m3 >= 0 are the same with two axes reversed;
// the separatrix is k = 1. So every motion except rotation about a fixed axis uses the same code, as do symmetric
// bodies (k = 0). The rotation is
//   R(t) = R(0) P(m(0))^T Y(psi(t) - psi(0)) P(m(t)),
// P the smallest rotation that brings m to axis 1, Y that about axis 1. (The 2007 preprint has lambda with the wrong
// sign; lambda here follows from m' = m x omega.)
//
// Accuracy near the separatrix rests on the complementary modulus, k'^2 = I31 D2 / (D3 I21): it is computed without
// cancellation.
#include "mechanics/free_body/free_rotation.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>
#include <utility>

#include "lie/so3.hpp"
#include "mechanics/free_body/elliptic.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Renames the axes (3, -2, 1).
void exchange_outer_axes(PrincipalAxes& p, Vec3& omega) {
    std::swap(p.I[0], p.I[2]);
    std::swap(omega[0], omega[2]);
    p.Q.col(0).swap(p.Q.col(2));
    p.Q.col(1) *= -1;
    omega[1] *= -1;
}

/// Reverses two axes such that omega(0), omega(2) >= 0.
void reverse_axes(PrincipalAxes& p, Vec3& omega) {
    const Vec3 sign(omega[0] < 0 ? -1 : 1, (omega[0] < 0) != (omega[2] < 0) ? -1 : 1, omega[2] < 0 ? -1 : 1);
    p.Q *= sign.asDiagonal();
    omega = sign.cwiseProduct(omega);
}

/// The motion in axes where it circles about axis 1 or is the separatrix; omega(0), omega(2) >= 0, and no rotation
/// about a fixed axis. I is ascending or descending.
class CirclingMotion {
  public:
    CirclingMotion(const Vec3& I, const Vec3& omega) : I_(I), G_(I.cwiseProduct(omega).norm()) {
        const Vec3 m = I.cwiseProduct(omega), e = m.cwiseProduct(omega);
        const Real I12 = I[0] - I[1], I31 = I[2] - I[0], I32 = I[2] - I[1];
        // D_j = G^2 - 2 T I_j, each without the cancellation of that form.
        const Real D1 = -e[1] * I12 + e[2] * I31, D2 = e[0] * I12 + e[2] * I32, D3 = -e[0] * I31 - e[1] * I32;
        amplitude_ = {sqrt(-I[0] * D3 / I31), sqrt(-I[1] * D1 / I12), sqrt(I[2] * D1 / I31)};
        k2_ = D1 * I32 / (D3 * I12);
        k12_ = -I31 * D2 / (D3 * I12);
        n_ = I[0] * I32 / (I[2] * I12);
        q_ = sqrt(-I[1] * I31 / (I[2] * I12));
        lambda_ = sqrt(D3 * I12 / (I[0] * I[1] * I[2]));
        if (I31 > 0) lambda_ = -lambda_;
        coefficient_ = -G_ * I31 / (lambda_ * I[0] * I[2]);
        start_ = elliptic_phase_of(-m[1] * amplitude_[2], m[2] * amplitude_[1], k12_);  // u = 0 at m2 = 0
    }

    Vec3 momentum(const EllipticPhase& p) const {
        return {amplitude_[0] * p.dn, -amplitude_[1] * p.sn, amplitude_[2] * p.cn};
    }
    const EllipticPhase& start() const { return start_; }
    EllipticPhase at(const Real& t) const { return elliptic_phase(lambda_ * t + start_.u, sqrt(k12_)); }

    /// psi(t) - psi(0).
    Real turn(const EllipticPhase& p, const Real& t) const {
        return G_ * t / I_[0] + (periodic_part(p) - periodic_part(start_));
    }

  private:
    /// The third-kind integral and the arctangent of q tan(am), unwrapped with am.
    Real periodic_part(const EllipticPhase& p) const {
        const Real s = p.sn, c = p.cn;
        const Real arctangent = p.am + atan2((q_ - 1) * s * c, c * c + q_ * s * s);
        return coefficient_ * third_kind(p, n_, k2_, k12_) - arctangent;
    }

    Vec3 I_, amplitude_;
    Real G_, k2_, k12_, n_, q_, lambda_, coefficient_;
    EllipticPhase start_;
};

/// The smallest rotation that brings the unit vector u, u[0] > -1, to axis 1.
Mat3 to_first_axis(const Vec3& u) {
    const Real y = u[1] / (1 + u[0]), z = u[2] / (1 + u[0]);
    Mat3 P;
    P << u[0], u[1], u[2],               //
        -u[1], 1 - y * u[1], -y * u[2],  //
        -u[2], -y * u[2], 1 - z * u[2];
    return P;
}

/// Negligible components are set to zero: they would reach the size of omega only after a turn of hundreds of
/// radians about the unstable axis, and their squares must not underflow.
void flush(Vec3& omega) {
    const Real negligible = ldexp(Real(1), -400);
    for (Real& component : omega)
        if (abs(component) < negligible) component = 0;
}

/// omega x J omega = 0.
bool is_stationary(const Vec3& I, const Vec3& omega) {
    const auto still = [&](int a, int b) { return I[a] == I[b] || omega[a] == 0 || omega[b] == 0; };
    return still(0, 1) && still(1, 2) && still(0, 2);
}

}  // namespace

PrincipalAxes principal_axes(const Mat3& J) {
    PrincipalAxes p{J.diagonal(), Mat3::Identity()};
    const Mat3 diagonal = p.I.asDiagonal();
    if (J != diagonal) {
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(J);
        p = {solver.eigenvalues(), solver.eigenvectors()};
    }
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)})
        if (p.I[a] > p.I[b]) {
            std::swap(p.I[a], p.I[b]);
            p.Q.col(a).swap(p.Q.col(b));
        }
    if (p.Q.determinant() < 0) p.Q.col(1) *= -1;
    return p;
}

FreeRotation FreeRotor::after(const Mat3& R0, const Vec3& omega0, const Real& t) const {
    const Real rate = omega0.norm();
    if (!isfinite(
            Real(rate + t + axes_.I.sum()))) {  // the library's integrals would look for a limit that does not exist
        const Real nan = std::numeric_limits<Real>::quiet_NaN();
        return {Mat3::Constant(nan), Vec3::Constant(nan)};
    }
    if (rate == 0 || t == 0) return {R0, omega0};
    PrincipalAxes axes = axes_;
    Vec3 omega = axes.Q.transpose() * omega0 / rate;  // time in units of 1/rate
    flush(omega);
    if (is_stationary(axes.I, omega)) return {R0 * SO3::exp(t * omega0), omega0};

    const Vec3& I = axes.I;
    if (I[0] * omega[0] * omega[0] * (I[0] - I[1]) + I[2] * omega[2] * omega[2] * (I[2] - I[1]) > 0)
        exchange_outer_axes(axes, omega);
    reverse_axes(axes, omega);

    const CirclingMotion motion(I, omega);
    const EllipticPhase now = motion.at(rate * t);
    const Vec3 m0 = motion.momentum(motion.start()), m = motion.momentum(now);
    const Mat3 Y = SO3::exp({motion.turn(now, rate * t), Real(0), Real(0)});
    const Mat3 turned = to_first_axis(m0.normalized()).transpose() * Y * to_first_axis(m.normalized());
    return {R0 * axes.Q * turned * axes.Q.transpose(), rate * (axes.Q * m.cwiseQuotient(I))};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
