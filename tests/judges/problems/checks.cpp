// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/problems/checks.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <functional>
#include <sstream>

namespace checks {

namespace {

/// Step of the differences: sixth order, so the error is about e^6 and eps/e of the size of what is differentiated.
#if KREISEL_QUAD
const Real e = Real(1) / 131072;
#else
const Real e = Real(1) / 512;
#endif
const Real difference_tolerance = 400 * epsilon / e;
const Real tolerance = 16000 * epsilon;  // complements have the square of the condition of M^{-1/2} C^T

/// d f(x)/dx at 0.
VecX derivative(const std::function<VecX(const Real&)>& f) {
    const auto difference = [&](int k) -> VecX { return f(k * e) - f(-k * e); };
    return (45 * difference(1) - 9 * difference(2) + difference(3)) / (60 * e);
}

/// A complaint if |got - expected| exceeds `limit` relative to `size`; also for NaN.
std::string compare(const std::string& what, const VecX& got, const VecX& expected, const Real& limit,
                    const Real& size) {
    const Real gap = (got - expected).norm();
    if (gap <= limit * max(Real(1), size)) return "";
    std::ostringstream out;
    out << what << ": off by " << to_double(gap) << ", allowed " << to_double(limit * max(Real(1), size));
    return out.str();
}

const Real* velocity(const System& s, const At& at) { return s.v(at.y.data()); }

/// State at (q, v) exp(x (u, a)).
std::vector<Real> moved(const System& s, const At& at, const VecX& u, const VecX& a, const Real& x) {
    VecX z(2 * s.velocities());
    z << x * u, x * a;
    std::vector<Real> y(at.y.size());
    s.state_group().append_exp(at.y.data(), z.data(), y.data());
    return y;
}

MatX jacobian(const System& s, const At& at) {
    MatX C(s.constraints(), s.velocities());
    s.jacobian(at.t, at.y.data(), C.data());
    return C;
}

VecX velocity_residual(const System& s, const Real& t, const std::vector<Real>& y) {
    VecX r(s.constraints());
    s.velocity_residual(t, y.data(), s.v(y.data()), r.data());
    return r;
}

VecX position_residual(const System& s, const Real& t, const std::vector<Real>& y) {
    VecX r(s.position_constraints());
    s.position_residual(t, y.data(), r.data());
    return r;
}

MatX mass_matrix(const System& s, const At& at) {
    const int n = s.velocities(), block = s.mass_block();
    std::vector<Real> blocks(static_cast<std::size_t>(n * block));
    s.mass(at.y.data(), blocks.data());
    MatX M = MatX::Zero(n, n);
    for (int i = 0; i < n / block; ++i)
        M.block(i * block, i * block, block, block) =
            Eigen::Map<MatX>(&blocks[static_cast<std::size_t>(i * block * block)], block, block);
    return M;
}

/// Largest velocity and acceleration, whose powers bound what is differentiated along the flow.
Real speed(const VecX& v, const VecX& a) {
    return max(Real(1), max(Real(v.lpNorm<Eigen::Infinity>()), Real(sqrt(a.lpNorm<Eigen::Infinity>()))));
}

/// Arbitrary, fixed numbers of size one.
VecX arbitrary(int n) {
    VecX a(n);
    for (int i = 0; i < n; ++i) a[i] = sin(Real(7 * i + 2));
    return a;
}

}  // namespace

std::string mass_is_positive(System& s, const At& at) {
    const MatX M = mass_matrix(s, at);
    if (M != M.transpose()) return "M is not symmetric";
    const Eigen::LLT<MatX> factor(M);
    return factor.info() == Eigen::Success && M.diagonal().minCoeff() > 0 ? "" : "M is not positive definite";
}

std::string jacobian_is_derivative(System& s, const At& at) {
    const int n = s.velocities();
    const MatX C = jacobian(s, at);
    for (int i = 0; i < n; ++i) {
        const VecX column = derivative([&](const Real& x) {
            return position_residual(s, at.t, moved(s, at, VecX::Unit(n, i), VecX::Zero(n), x));
        });
        const std::string complaint = compare("column " + std::to_string(i) + " of C", C.col(i).head(column.size()),
                                              column, difference_tolerance, C.norm());
        if (!complaint.empty()) return complaint;
    }
    return "";
}

std::string velocity_rows_are_consistent(System& s, const At& at) {
    VecX b(s.constraints());
    s.velocity_bias(at.t, at.y.data(), b.data());
    const VecX partial = derivative([&](const Real& x) { return position_residual(s, at.t + x, at.y); });
    const std::string complaint = compare("b", b.head(partial.size()), partial, difference_tolerance, b.norm());
    if (!complaint.empty()) return complaint;
    const VecX v = Eigen::Map<const VecX>(velocity(s, at), s.velocities());
    return compare("C v + b", velocity_residual(s, at.t, at.y), jacobian(s, at) * v + b, tolerance, v.norm());
}

std::string bias_is_derivative(System& s, const At& at) {
    const VecX v = Eigen::Map<const VecX>(velocity(s, at), s.velocities()), a = arbitrary(s.velocities());
    VecX xi(s.constraints());
    s.acceleration_bias(at.t, at.y.data(), v.data(), xi.data());
    const Real fast = speed(v, a);
    // Time runs slower at high speeds: the difference then spans the same angle.
    const VecX rate = fast * derivative([&](const Real& x) {
                          return velocity_residual(s, at.t + x / fast, moved(s, at, v, a, x / fast));
                      });
    return compare("xi", jacobian(s, at) * a - xi, rate, difference_tolerance, fast * fast + xi.norm());
}

std::string accelerations_solve_kkt(System& s, const At& at) {
    const int n = s.velocities(), m = s.constraints();
    VecX dv(n), lambda(m), applied(n), gyroscopic(n), xi(m);
    const Real* v = velocity(s, at);
    if (s.accelerations(at.t, at.y.data(), v, dv.data(), m > 0 ? lambda.data() : nullptr) != Status::ok)
        return "the index-1 system has no solution";
    s.applied_force(at.t, at.y.data(), v, applied.data());
    s.gyroscopic_force(at.y.data(), v, gyroscopic.data());
    s.acceleration_bias(at.t, at.y.data(), v, xi.data());
    const MatX M = mass_matrix(s, at), C = jacobian(s, at);
    const std::string complaint =
        compare("M v' + C^T lambda", M * dv + C.transpose() * lambda, applied + gyroscopic, tolerance,
                (M * dv).norm() + lambda.norm() + applied.norm() + gyroscopic.norm());
    if (!complaint.empty()) return complaint;
    VecX quick(n);
    s.accelerations(at.t, at.y.data(), v, quick.data(), nullptr);
    const std::string other = compare("v' without multipliers", quick, dv, tolerance, dv.norm());
    return other.empty() ? compare("C v'", C * dv, xi, tolerance, dv.norm() + xi.norm()) : other;
}

std::string force_is_gradient(System& s, const At& at) {
    if (!s.has_potential()) return "";
    const int n = s.velocities();
    VecX applied(n);
    s.applied_force(at.t, at.y.data(), velocity(s, at), applied.data());
    for (int i = 0; i < n; ++i) {
        const VecX slope = derivative([&](const Real& x) {
            return VecX::Constant(1, s.potential(at.t, moved(s, at, VecX::Unit(n, i), VecX::Zero(n), x).data()));
        });
        const std::string complaint =
            compare("component " + std::to_string(i) + " of the force", applied.segment(i, 1), -slope,
                    difference_tolerance, applied.norm() + abs(s.potential(at.t, at.y.data())));
        if (!complaint.empty()) return complaint;
    }
    return "";
}

std::string force_parts_add_up(System& s, const At& at) {
    const int n = s.velocities();
    const VecX v = Eigen::Map<const VecX>(velocity(s, at), n), rest = VecX::Zero(n);
    VecX applied(n), at_rest(n), conservative(n), dissipative(n);
    s.applied_force(at.t, at.y.data(), v.data(), applied.data());
    s.applied_force(at.t, at.y.data(), rest.data(), at_rest.data());
    s.conservative_force(at.t, at.y.data(), conservative.data());
    s.dissipative_force(at.t, at.y.data(), v.data(), dissipative.data());
    const Real size = conservative.norm() + dissipative.norm();
    const std::string complaint =
        compare("the sum of both parts", conservative + dissipative, applied, tolerance, size);
    if (!complaint.empty()) return complaint;
    if (conservative != at_rest) return "the conservative part is not what acts at rest";
    if (!s.is_dissipative()) return dissipative.isZero(0) ? "" : "a dissipative force without dampers";
    return dissipative.dot(v) <= tolerance * dissipative.norm() * v.norm() ? "" : "dampers feed energy in";
}

std::string integrals_are_constant(System& s, const At& at) {
    const int n = s.velocities();
    const VecX v = Eigen::Map<const VecX>(velocity(s, at), n);
    VecX a(n);
    if (s.evaluate(at.t, at.y.data(), v.data(), a.data()) != Status::ok) return "the index-1 system has no solution";
    const Real fast = speed(v, a);
    std::vector<BodyState> bodies(static_cast<std::size_t>(s.bodies()));
    std::vector<SpringAngle> springs(static_cast<std::size_t>(s.torsion_springs()));
    std::vector<Real> angles;
    const auto along = [&](const std::function<Real(const MotionState&)>& f, const Real& x) {
        const std::vector<Real> y = moved(s, at, v, a, x / fast);
        s.read(y.data(), bodies.data());
        s.read_angles(y.data(), springs.data());
        angles.clear();
        for (const SpringAngle& spring : springs) angles.push_back(spring.theta);
        return f({bodies, angles});
    };
    for (const FirstIntegral& integral : s.integrals()) {
        const VecX rate = derivative([&](const Real& x) { return VecX::Constant(1, along(integral.value, x)); });
        const std::string complaint =
            compare(integral.name, rate, VecX::Zero(1), difference_tolerance, along(integral.size, 0));
        if (!complaint.empty()) return complaint;
        if (integral.reason.empty() || integral.unit.empty()) return integral.name + " has no reason or no unit";
    }
    return "";
}

Dynamics dynamics(System& s, const At& at) {
    const int n = s.velocities(), count = s.bodies();
    const VecX v = Eigen::Map<const VecX>(velocity(s, at), n);
    Dynamics d{VecX::Constant(6 * count, std::numeric_limits<Real>::quiet_NaN()), VecX(s.constraints())};
    VecX a(n);
    if (s.accelerations(at.t, at.y.data(), v.data(), a.data(), s.constraints() > 0 ? d.multipliers.data() : nullptr) !=
        Status::ok)
        return d;
    std::vector<BodyState> bodies(static_cast<std::size_t>(count));
    const Real fast = speed(v, a);
    d.accelerations = fast * derivative([&](const Real& x) {
                          s.read(moved(s, at, v, a, x / fast).data(), bodies.data());
                          VecX rates(6 * count);
                          for (int i = 0; i < count; ++i)
                              rates.segment<6>(6 * i) << bodies[static_cast<std::size_t>(i)].v,
                                  bodies[static_cast<std::size_t>(i)].omega;
                          return rates;
                      });
    return d;
}

std::string same_dynamics(const Dynamics& a, const Dynamics& b) {
    const Real size = max(Real(a.accelerations.norm()), Real(b.accelerations.norm()));
    const std::string complaint =
        compare("x'' and omega'", a.accelerations, b.accelerations, 10 * difference_tolerance, size);
    if (!complaint.empty() || a.multipliers.size() != b.multipliers.size()) return complaint;
    return compare("multipliers", a.multipliers, b.multipliers, tolerance, a.multipliers.norm());
}

}  // namespace checks
