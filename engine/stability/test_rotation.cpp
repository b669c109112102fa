// SPDX-License-Identifier: BSD-3-Clause
#include "engine/stability/test_rotation.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "engine/linearised/spectrum.hpp"
#include "mechanics/formulation.hpp"
#include "methods/contract/integrator.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int delays = 5;    // more than any method remembers
constexpr int starting = 6;  // steps of a method with memory that may be others

/// A unit inertia about the z axis, and a spring of 1 N m/rad: Omega = 1/s.
Model test_model() {
    Model model;
    model.bodies.push_back({.name = "rotor", .mass = 1, .J = Mat3::Identity(), .start = {}});
    model.torsion_springs.push_back({.first = ground, .second = 0, .stiffness = 1});
    return model;
}

std::string why_not(const Method& method, const OptionValues& options, const System& system) {
    const MethodDescription& description = method.description;
    if (description.own_control) return "it chooses its steps itself";
    const auto& only = description.formulations;
    if (!only.empty() && std::find(only.begin(), only.end(), "SO3") == only.end()) return "it does not run as SO3";
    if (const std::string reason = method.factory.why_not(options); !reason.empty()) return reason;
    const std::string declined = method.factory.declines ? method.factory.declines(system) : "";
    return declined.empty() ? "" : "it does not treat " + declined;
}

/// Small: rotations turn about one axis, but some coordinates are not linear in the angle.
Real amplitude() { return cbrt(epsilon); }

/// Of a matrix of two rows from its trace and determinant, which keeps all digits of a modulus of 1.
Real spectral_radius(const MatX& A) {
    if (!A.allFinite()) return std::numeric_limits<Real>::quiet_NaN();
    if (A.rows() == 2) {
        const Real half = (A(0, 0) + A(1, 1)) / 2, det = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
        const Real square = half * half - det;
        return square < 0 ? Real(sqrt(det)) : Real(abs(half) + sqrt(square));
    }
    Real radius = 0;
    for (const SpectrumEntry& mu : spectrum(A, 1))
        radius = max(radius, Real(sqrt(mu.real * mu.real + mu.imaginary * mu.imaginary)));
    return radius;
}

}  // namespace

TestRotation::TestRotation(const Method& method, const OptionValues& options)
    : model_(test_model()), system_(make_system(model_, "SO3")), has_memory_(method.description.keeps_memory) {
    if (const std::string reason = why_not(method, options, *system_); !reason.empty()) throw std::domain_error(reason);
    integrator_ = method.bind(*system_, options);
}

TestRotation::~TestRotation() = default;

MatX TestRotation::motion(const Real& theta, const Real& rate, const Real& h, int steps) {
    BodyState& start = model_.bodies[0].start;
    start.R = SO3::exp(Vec3(0, 0, theta)), start.omega = Vec3(0, 0, rate);
    std::vector<Real> y = initial_state(*system_, model_);
    MatX z(2, steps + 1);
    z.col(0) << theta, rate;
    Status status = integrator_->start(0, y.data());
    for (int i = 1; i <= steps; ++i) {
        if (status == Status::ok) status = integrator_->step(h * (i - 1), h, y.data());
        BodyState state;
        system_->read(y.data(), &state);
        z.col(i) << SO3::log(state.R)[2], state.omega[2];
        if (status != Status::ok) z.setConstant(std::numeric_limits<Real>::quiet_NaN());
    }
    return z;
}

MatX TestRotation::step_matrix(const Real& h) {
    const Real a = amplitude();
    MatX A(2, 2);
    A << motion(a, 0, h, 1).col(1) / a, motion(0, a, h, 1).col(1) / a;
    return A;
}

MatX TestRotation::recurrence_matrix(const Real& h) {
    constexpr int columns = 2 * delays + 2, steps = starting + delays + columns;
    MatX before(2 * delays, 2 * columns), after = before;
    for (const int which : {0, 1}) {
        const MatX z = motion(which == 0 ? amplitude() : Real(0), which == 0 ? Real(0) : amplitude(), h, steps);
        for (int i = 0; i < columns; ++i) {
            const int column = which * columns + i;
            for (int k = 0; k < delays; ++k) {
                before.block(2 * k, column, 2, 1) = z.col(starting + i + k);
                after.block(2 * k, column, 2, 1) = z.col(starting + i + k + 1);
            }
            const Real size = before.col(column).norm();
            before.col(column) /= size, after.col(column) /= size;
        }
    }
    if (!before.allFinite() || !after.allFinite())
        return MatX::Constant(2 * delays, 2 * delays, std::numeric_limits<Real>::quiet_NaN());
    Eigen::CompleteOrthogonalDecomposition<MatX> decomposition;
    decomposition.setThreshold(amplitude() * amplitude());
    decomposition.compute(before.transpose());
    return decomposition.solve(after.transpose()).transpose();
}

Real TestRotation::amplification(const Real& h) {
    return spectral_radius(has_memory_ ? recurrence_matrix(h) : step_matrix(h));
}

Real TestRotation::round_off() const { return has_memory_ ? Real(10 * amplitude()) : 10 * amplitude() * amplitude(); }

RotationStability rotation_stability(const Method& method, const OptionValues& options) try {
    constexpr int first = 8, finest = 16, uniform = 8, largest = 100, bisections = 24;
    TestRotation rotation(method, options);
    const auto is_stable = [&](const Real& h) { return rotation.amplification(h) <= 1 + rotation.round_off(); };
    RotationStability found;
    found.growth = to_double(rotation.amplification(Real(1) / 2) - 1);
    Real low = 0, high = Real(1) / first;
    for (; high <= largest && is_stable(high); high = high < uniform ? high + Real(1) / finest : high * 5 / 4)
        low = high;
    if (low == 0) return found;
    found.bounded = high <= largest;
    for (int i = 0; found.bounded && i < bisections; ++i) {
        const Real middle = (low + high) / 2;
        (is_stable(middle) ? low : high) = middle;
    }
    found.limit = to_double(low);
    return found;
} catch (const std::domain_error& reason) { return {.refusal = reason.what()}; }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
