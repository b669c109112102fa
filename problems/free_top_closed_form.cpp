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
// cancellation, which k (the only argument of the library's Jacobi functions) does not allow. For the same reason Pi of
// negative characteristic is turned into one of positive characteristic, a sum of positive terms.
#include "problems/free_top_closed_form.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "lie/so3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Moments I(0) <= I(1) <= I(2), and the right-handed principal axes as columns, in body axes.
struct PrincipalAxes {
    Vec3 I;
    Mat3 Q;
};

/// A diagonal J is only sorted, so that exact relations between its moments stay exact.
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

/// An argument u of the Jacobi functions, am(u) unwrapped, and sn, cn, dn there.
struct Phase {
    Real u, am, sn, cn, dn;
};

/// Jacobi functions from the complementary modulus k' in [0, 1], by the arithmetic-geometric mean and descending
/// Landen transformations (Abramowitz & Stegun, 16.4), the arcsines as arctangents that keep their digits at k = 1.
Phase jacobi(const Real& u, const Real& k1) {
    using std::atan, std::cosh, std::tanh;
    if (k1 == 0) {
        const Real sech = max(Real(1 / cosh(u)), std::numeric_limits<Real>::min());  // cn/dn = 1 to the end
        return {u, 2 * atan(tanh(u / 2)), tanh(u), sech, sech};
    }
    struct Mean {
        Real a, b, c;
    };
    std::vector<Mean> means{{Real(1), k1, Real(0)}};
    do {
        const Mean& m = means.back();
        means.push_back({(m.a + m.b) / 2, sqrt(m.a * m.b), (m.a - m.b) / 2});
    } while (means.back().c > epsilon * means.back().a);
    Real phi = means.back().a * u;
    for (std::size_t n = 1; n < means.size(); ++n) phi *= 2;
    for (std::size_t n = means.size() - 1; n > 0; --n) {
        const auto& [a, b, c] = means[n];
        const Real s = sin(phi), co = cos(phi);
        phi = (phi + atan2(c * s, sqrt(a * a * co * co + b * b * s * s))) / 2;
    }
    const Real s = sin(phi), c = cos(phi);
    return {u, phi, s, c, sqrt(c * c + k1 * k1 * s * s)};
}

/// Pi(am u, N, k) for N in [k^2, 1), by Carlson's R_J; `complement` is 1 - N without cancellation, k12 = k'^2 > 0.
Real third_kind_positive(const Phase& p, const Real& N, const Real& complement, const Real& k12) {
    using boost::math::ellint_rj, std::round;
    const Real half_turns = round(p.am / pi()), sign = cos(half_turns * pi()) < 0 ? -1 : 1;
    const Real s = sign * p.sn, s2 = s * s, c2 = p.cn * p.cn;
    const Real part = s * s2 * ellint_rj(c2, p.dn * p.dn, Real(1), c2 + complement * s2);
    const Real whole = half_turns == 0 ? Real(0) : 2 * half_turns * ellint_rj(Real(0), k12, Real(1), complement);
    return p.u + N / 3 * (part + whole);
}

/// Pi(am u, n, k) for n <= 0: the integral of 1 / (1 - n sn^2) over [0, u], through the characteristic
/// N = (k^2 - n)/(1 - n) in [k^2, 1] (Abramowitz & Stegun, 17.7.15 and 17.7.16).
Real third_kind(const Phase& p, const Real& n, const Real& k2, const Real& k12) {
    if (n == 0) return p.u;
    const Real N = (k2 - n) / (1 - n), d = k2 - n;
    const Real rest = k2 / d * p.u + atan2(sqrt(-n * N) * p.sn * p.cn, p.dn) * sqrt(-n / (d * (1 - n)));
    if (k12 == 0) return rest;
    return rest - n * k12 / ((1 - n) * d) * third_kind_positive(p, N, k12 / (1 - n), k12);
}

/// The motion in axes where it circles about axis 1 or is the separatrix; omega(0), omega(2) >= 0, and no rotation
/// about a fixed axis. I is ascending or descending.
class Motion {
  public:
    Motion(const Vec3& I, const Vec3& omega) : I_(I), G_(I.cwiseProduct(omega).norm()) {
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
        start_ = start_phase(m);
    }

    Vec3 momentum(const Phase& p) const { return {amplitude_[0] * p.dn, -amplitude_[1] * p.sn, amplitude_[2] * p.cn}; }
    const Phase& start() const { return start_; }
    Phase at(const Real& t) const { return jacobi(lambda_ * t + start_.u, sqrt(k12_)); }

    /// psi(t) - psi(0).
    Real turn(const Phase& p, const Real& t) const {
        return G_ * t / I_[0] + (periodic_part(p) - periodic_part(start_));
    }

  private:
    /// F(am, k) by Carlson's R_F; u = 0 at m2 = 0.
    Phase start_phase(const Vec3& m) const {
        Real s = -m[1] * amplitude_[2], c = m[2] * amplitude_[1];
        const Real size = sqrt(s * s + c * c);
        s /= size, c /= size;
        const Real d2 = c * c + k12_ * s * s;
        return {s * boost::math::ellint_rf(c * c, d2, Real(1)), atan2(s, c), s, c, sqrt(d2)};
    }
    /// The third-kind integral and the arctangent of q tan(am), unwrapped with am.
    Real periodic_part(const Phase& p) const {
        const Real s = p.sn, c = p.cn;
        const Real arctangent = p.am + atan2((q_ - 1) * s * c, c * c + q_ * s * s);
        return coefficient_ * third_kind(p, n_, k2_, k12_) - arctangent;
    }

    Vec3 I_, amplitude_;
    Real G_, k2_, k12_, n_, q_, lambda_, coefficient_;
    Phase start_;
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
    Real negligible = 1;
    for (int i = 0; i < 400; ++i) negligible /= 2;
    for (Real& component : omega)
        if (abs(component) < negligible) component = 0;
}

/// omega x J omega = 0.
bool is_stationary(const Vec3& I, const Vec3& omega) {
    const auto still = [&](int a, int b) { return I[a] == I[b] || omega[a] == 0 || omega[b] == 0; };
    return still(0, 1) && still(1, 2) && still(0, 2);
}

}  // namespace

FreeRotation free_rotation(const Mat3& J, const Mat3& R0, const Vec3& omega0, const Real& t) {
    const Real rate = omega0.norm();
    if (rate == 0) return {R0, omega0};
    PrincipalAxes axes = principal_axes(J);
    Vec3 omega = axes.Q.transpose() * omega0 / rate;  // time in units of 1/rate
    flush(omega);
    if (is_stationary(axes.I, omega)) return {R0 * SO3::exp(t * omega0), omega0};

    const Vec3& I = axes.I;
    if (I[0] * omega[0] * omega[0] * (I[0] - I[1]) + I[2] * omega[2] * omega[2] * (I[2] - I[1]) > 0)
        exchange_outer_axes(axes, omega);
    reverse_axes(axes, omega);

    const Motion motion(I, omega);
    const Phase now = motion.at(rate * t);
    const Vec3 m0 = motion.momentum(motion.start()), m = motion.momentum(now);
    const Mat3 Y = SO3::exp({motion.turn(now, rate * t), Real(0), Real(0)});
    const Mat3 turned = to_first_axis(m0.normalized()).transpose() * Y * to_first_axis(m.normalized());
    return {R0 * axes.Q * turned * axes.Q.transpose(), rate * (axes.Q * m.cwiseQuotient(I))};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
