// SPDX-License-Identifier: BSD-3-Clause
//
// With u the cosine of the angle between axis and upward vertical, omega_3 that about the axis and
//   a = C omega_3/A,   b = L_z/A,   beta = 2 moment/A,   alpha = |omega_transverse|^2 + beta u,
// all constant, the inclination obeys u'^2 = f(u) = (alpha - beta u)(1 - u^2) - (b - a u)^2, whose roots are
// -1 <= u1 <= u2 <= 1 <= u3. Hence
//   u = u1 + (u2 - u1) sn^2(w, k),   w = kappa t + w0,   kappa^2 = beta (u3 - u1)/4,   k^2 = (u2 - u1)/(u3 - u1),
// and precession and spin follow by quadrature of
//   phi' = (b - a u)/(1 - u^2) = (b - a)/2 / (1 - u) + (b + a)/2 / (1 + u),   psi' = omega_3 - u phi',
// each term an elliptic integral of the third kind. The attitude is, in frames with third axes up and axis,
// Rz(phi) Ry(theta) Rz(psi).
//
// Where the motion starts near a turning point, u2 - u(0) has no digits: the start of the phase is taken from u'(0).
// The literature's fast top swings within 1e-12 of the downward vertical, where 1 + u1 has few digits: it is taken from
// f(-1).
#include "problems/lagrange_top_closed_form.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "lie/so3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// A rotation whose third column is the unit vector e.
Mat3 frame(const Vec3& e) {
    Eigen::Index smallest = 0;
    e.cwiseAbs().minCoeff(&smallest);
    const Vec3 first = Vec3::Unit(smallest).cross(e).normalized();
    Mat3 Q;
    Q << first, e.cross(first), e;
    return Q;
}

/// f and its coefficients; sum = b + a and difference = b - a are stored separately: they determine how near to the
/// vertical the axis comes.
struct Inclination {
    Real a, alpha, beta, sum, difference;
    /// b - a u.
    Real numerator(const Real& u) const { return u < 0 ? Real(sum - a * (1 + u)) : Real(difference + a * (1 - u)); }
    Real f(const Real& u) const { return (alpha - beta * u) * (1 - u) * (1 + u) - numerator(u) * numerator(u); }
    Real slope(const Real& u) const { return -beta * (1 - u * u) - 2 * u * (alpha - beta * u) + 2 * a * numerator(u); }
    Real sum_of_roots() const { return (alpha + a * a) / beta; }
};

struct Roots {
    Real u1, u2, u3;
    Real above, below;  // 1 + u1 and 1 - u2, without cancellation
};

/// The root between `inside`, where f > 0, and `outside` = -1 or 1, where f <= 0.
Real root(const Inclination& c, const Real& inside, const Real& outside) {
    if (c.f(outside) >= 0) return outside;
    std::uintmax_t iterations = 500;
    const auto f = [&](const Real& u) { return c.f(u); };
    const auto same = [](const Real& x, const Real& y) { return abs(x - y) <= 2 * epsilon; };
    const auto [low, high] =
        boost::math::tools::toms748_solve(f, min(inside, outside), max(inside, outside), same, iterations);
    return (low + high) / 2;
}

/// The roots where one of them is u0: f(u) = (u - u0)(beta u^2 - s u + p).
Roots roots_with(const Inclination& c, const Real& u0) {
    const Real s = c.beta * (c.sum_of_roots() - u0);
    const Real p = c.slope(u0) - c.beta * u0 * u0 + s * u0;
    const Real larger = (s + sqrt(max(Real(s * s - 4 * c.beta * p), Real(0)))) / 2;
    const Real other = p / larger;
    return {min(u0, other), max(u0, other), larger / c.beta, 0, 0};
}

/// From u(0) and u'(0). Next to a turning point, at a distance whose square is below round-off, f(u(0)) = u'(0)^2 has
/// no digits, and the root is one Newton step away. f(1) and f(-1) give the distances of u2 and u1 from there.
Roots roots(const Inclination& c, const Real& u0, const Real& rate) {
    const Real slope = c.slope(u0), square = rate * rate;
    Roots r;
    if (square <= sqrt(epsilon) / 16 * abs(slope)) {
        r = roots_with(c, slope == 0 ? u0 : Real(u0 - square / slope));
    } else {
        r.u1 = root(c, u0, Real(-1)), r.u2 = root(c, u0, Real(1));
        r.u3 = c.sum_of_roots() - r.u1 - r.u2;
    }
    r.above = 1 + r.u1, r.below = 1 - r.u2;
    const Real half = Real(1) / 2;
    if (r.above < half) r.above = c.sum * c.sum / (c.beta * (1 + r.u2) * (1 + r.u3));
    if (r.below < half && r.u3 - 1 > half) r.below = c.difference * c.difference / (c.beta * (1 - r.u1) * (r.u3 - 1));
    return r;
}

/// Argument and amplitude of the Jacobi functions, and their values.
struct Phase {
    Real w, am, sn, cn, dn;
};

Phase start_phase(const Roots& r, const Real& beta, const Real& u0, const Real& rate, const Real& k) {
    const Real range = r.u2 - r.u1, scale = beta * (r.u3 - u0) * range;
    Real sn = sqrt((u0 - r.u1) / range), cn = rate / sqrt(scale * (u0 - r.u1));
    if (u0 - r.u1 < r.u2 - u0) {
        sn = abs(rate) / sqrt(scale * (r.u2 - u0));
        cn = sqrt((r.u2 - u0) / range) * (rate < 0 ? -1 : 1);
    }
    const Real am = atan2(sn, cn), s = sin(am);
    return {boost::math::ellint_1(k, am), am, s, cos(am), sqrt(1 - k * k * s * s)};
}

Phase phase_at(const Real& w, const Real& k) {
    using std::round;
    Phase p{w, 0, 0, 0, 0};
    p.sn = boost::math::jacobi_elliptic(k, w, &p.cn, &p.dn);
    const Real half_turns = round(w / (2 * boost::math::ellint_1(k)));
    const Real sign = cos(half_turns * pi()) < 0 ? -1 : 1;
    p.am = half_turns * pi() + atan2(sign * p.sn, sign * p.cn);
    return p;
}

/// Integral of 1/(1 - n sn^2) over [from, to].
Real third_kind(const Phase& from, const Phase& to, const Real& n, const Real& k) {
    return boost::math::ellint_3(k, n, to.am) - boost::math::ellint_3(k, n, from.am);
}

Mat3 rotation(const Real& phi, const Real& sine, const Real& cosine, const Real& psi) {
    Mat3 Y;
    Y << cosine, 0, sine, 0, 1, 0, -sine, 0, cosine;
    return SO3::exp(Vec3(0, 0, phi)) * Y * SO3::exp(Vec3(0, 0, psi));
}

/// The motion in frames with third axes up and axis.
class TopMotion {
  public:
    TopMotion(const LagrangeTop& top, const Mat3& M, const Vec3& omega)
        : axial_(omega[2]), phi0_(atan2(M(1, 2), M(0, 2))), psi0_(atan2(M(2, 1), -M(2, 0))) {
        u0_ = M(2, 2);
        rate_ = M(2, 0) * omega[1] - M(2, 1) * omega[0];
        const Real transverse = omega[0] * omega[0] + omega[1] * omega[1];
        c_.a = top.axial * axial_ / top.transverse;
        const Real vertical = M(2, 0) * omega[0] + M(2, 1) * omega[1];
        c_.sum = vertical + c_.a * (1 + u0_), c_.difference = vertical - c_.a * (1 - u0_);
        c_.beta = 2 * top.moment / top.transverse;
        c_.alpha = transverse + c_.beta * u0_;
        r_ = roots(c_, u0_, rate_);
        const Real near = 1024 * epsilon;
        if (r_.below < near * near || r_.above < near * near)
            throw std::domain_error("the axis of this top passes through the vertical: no angles of precession there");
    }

    /// The inclination does not change, to round-off.
    bool is_steady() const { return r_.u2 - r_.u1 <= 1024 * epsilon; }
    SteadyPrecession steady() const {
        const Real precession = precession_rate(u0_);
        return {precession, axial_ - u0_ * precession};
    }

    TopState at(const Real& t) const {
        const Real kappa = sqrt(c_.beta * (r_.u3 - r_.u1)) / 2, k = sqrt((r_.u2 - r_.u1) / (r_.u3 - r_.u1));
        const Phase from = start_phase(r_, c_.beta, u0_, rate_, k), to = phase_at(kappa * t + from.w, k);
        const Real range = r_.u2 - r_.u1, below = 1 - r_.u1;
        const Real I1 = c_.difference / (2 * kappa * below) * third_kind(from, to, range / below, k);
        const Real I2 = c_.sum / (2 * kappa * r_.above) * third_kind(from, to, -range / r_.above, k);
        const Real phi = phi0_ + I1 + I2, psi = psi0_ + (axial_ - c_.a) * t - I1 + I2;
        const Real u = r_.u1 + range * to.sn * to.sn, s2 = range * to.sn * to.sn, c2 = range * to.cn * to.cn;
        const Real sine = sqrt((r_.below + c2) * (r_.above + s2));
        const Real theta_rate = -2 * kappa * range * to.sn * to.cn * to.dn / sine,
                   phi_rate = numerator(s2, c2, u) / (sine * sine);
        return {rotation(phi, sine, u, psi),
                {theta_rate * sin(psi) - phi_rate * sine * cos(psi), theta_rate * cos(psi) + phi_rate * sine * sin(psi),
                 axial_}};
    }

  private:
    Real precession_rate(const Real& u) const { return c_.numerator(u) / ((1 - u) * (1 + u)); }
    /// b - a u.
    Real numerator(const Real& s2, const Real& c2, const Real& u) const {
        return u < 0 ? Real(c_.sum - c_.a * (r_.above + s2)) : Real(c_.difference + c_.a * (r_.below + c2));
    }

    Real axial_, phi0_, psi0_, u0_, rate_;
    Inclination c_;
    Roots r_;
};

/// quadratic Omega^2 - linear Omega + constant = 0.
struct PrecessionEquation {
    Real cosine, quadratic, linear, constant;
    /// The larger root of q^2 - linear q + quadratic constant = 0: q = quadratic Omega_fast = constant/Omega_slow.
    Real larger() const {
        const Real discriminant = linear * linear - 4 * quadratic * constant;
        if (discriminant < 0 || (linear == 0 && quadratic == 0))
            throw std::domain_error("this top is too slow for a steady precession at this inclination");
        return (linear + (linear < 0 ? -1 : 1) * sqrt(discriminant)) / 2;
    }
};

PrecessionEquation precession_equation(const LagrangeTop& top, const Mat3& R, const Real& axial) {
    const Real cosine = top.up.dot(R * top.axis);
    return {cosine, top.transverse * cosine, top.axial * axial, top.moment};
}

}  // namespace

LagrangeTop lagrange_top(const Body& body, const Vec3& lever, const Vec3& gravity) {
    const Real length = lever.norm(), g = gravity.norm();
    if (length == 0 || g == 0) throw std::domain_error("a Lagrange top needs a lever and gravity");
    const Mat3 J = inertia_about(body, lever);
    const Vec3 axis = lever / length;
    const Real axial = axis.dot(J * axis), transverse = (J.trace() - axial) / 2;
    const Mat3 symmetric = transverse * Mat3::Identity() + (axial - transverse) * axis * axis.transpose();
    if ((J - symmetric).norm() > 1024 * epsilon * J.norm())
        throw std::domain_error("this body is not symmetric about the line from the fixed point to its mass centre");
    return {transverse, axial, axis, -gravity / g, body.mass * g * length};
}

TopState lagrange_motion(const LagrangeTop& top, const TopState& start, const Real& t) {
    const Mat3 K = frame(top.up), Q = frame(top.axis);
    const TopMotion motion(top, K.transpose() * start.R * Q, Q.transpose() * start.omega);
    if (motion.is_steady()) return steady_motion(top, motion.steady(), start.R, t);
    const TopState end = motion.at(t);
    return {K * end.R * Q.transpose(), Q * end.omega};
}

SteadyPrecession slow_precession(const LagrangeTop& top, const Mat3& R, const Real& axial) {
    const PrecessionEquation equation = precession_equation(top, R, axial);
    const Real precession = equation.constant / equation.larger();
    return {precession, axial - precession * equation.cosine};
}

SteadyPrecession fast_precession(const LagrangeTop& top, const Mat3& R, const Real& axial) {
    const PrecessionEquation equation = precession_equation(top, R, axial);
    if (equation.quadratic == 0) throw std::domain_error("a horizontal axis has one steady precession only");
    const Real precession = equation.larger() / equation.quadratic;
    return {precession, axial - precession * equation.cosine};
}

TopState steady_motion(const LagrangeTop& top, const SteadyPrecession& motion, const Mat3& R, const Real& t) {
    const Mat3 moved = SO3::exp(motion.precession * t * top.up) * R * SO3::exp(motion.spin * t * top.axis);
    return {moved, moved.transpose() * (motion.precession * top.up) + motion.spin * top.axis};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
