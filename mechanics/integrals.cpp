// SPDX-License-Identifier: BSD-3-Clause
//
// First integrals found from the structure of a model. Each is declared only where its reason holds.
#include "mechanics/integrals.hpp"

#include <algorithm>

#include "mechanics/formulation.hpp"
#include "mechanics/model/driven.hpp"
#include "mechanics/model/symmetries.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using Bodies = std::span<const BodyState>;
/// Integrals outlive the model they were found in, and share one copy of it.
using Shared = std::shared_ptr<const Model>;
constexpr const char* axis_names[] = {"x", "y", "z"};

/// Without velocities, on which no stored energy depends.
Motion pose(Bodies states, int body) {
    if (body == ground) return {};
    const BodyState& s = states[static_cast<std::size_t>(body)];
    return {s.x, s.R};
}

/// A quantity and the sum of the sizes of its terms, which its round-off scales with.
struct Terms {
    Real value = 0, size = 0;
    void add(const Real& term) { add(term, abs(term)); }
    void add(const Real& term, const Real& bound) { value += term, size += bound; }
};

Terms energy(const Model& model, const MotionState& state) {
    Terms sum;
    for (std::size_t i = 0; i < state.bodies.size(); ++i) {
        const Body& body = model.bodies[i];
        const BodyState& s = state.bodies[i];
        sum.add(body.mass * s.v.squaredNorm() / 2 + s.omega.dot(body.J * s.omega) / 2);
        sum.add(-body.mass * model.gravity.g.dot(s.x), body.mass * model.gravity.g.norm() * s.x.norm());
    }
    const auto at = [&](int body) { return pose(state.bodies, body); };
    sum.add(stored_energy(model, at, [&](std::size_t i) { return state.angles[i]; }));
    return sum;
}

/// e . sum ((x - P) x m v + R J omega).
Terms angular_momentum(const Model& model, const Line& axis, Bodies states) {
    Terms sum;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Body& body = model.bodies[i];
        const BodyState& s = states[i];
        const Vec3 arm = s.x - axis.P, spin = body.J * s.omega;
        sum.add(axis.e.dot(arm.cross(body.mass * s.v) + s.R * spin), arm.norm() * body.mass * s.v.norm() + spin.norm());
    }
    return sum;
}

/// e . sum m v.
Terms momentum(const Model& model, const Vec3& e, Bodies states) {
    Terms sum;
    for (std::size_t i = 0; i < states.size(); ++i)
        sum.add(model.bodies[i].mass * e.dot(states[i].v), model.bodies[i].mass * states[i].v.norm());
    return sum;
}

/// (p^2 - q^2 - c gamma_1)^2 + (2 p q - c gamma_2)^2 with (p, q) and gamma, the upward vertical, along e_1 and e_2.
Terms kovalevskaya(const KovalevskayaTop& top, const BodyState& s) {
    const Vec3 omega = top.axes.transpose() * s.omega, gamma = top.axes.transpose() * (s.R.transpose() * top.up);
    const Real p = omega[0], q = omega[1];
    const Real real = p * p - q * q - top.c * gamma[0], imaginary = 2 * p * q - top.c * gamma[1];
    const Real bound = p * p + q * q + top.c;
    Terms sum;
    sum.add(real * real + imaginary * imaginary, bound * bound);
    return sum;
}

/// A first integral from f(state) -> Terms, with its name, unit and reason.
template <class F>
FirstIntegral integral(std::string name, const char* unit, std::string reason, F f) {
    return {std::move(name), unit, std::move(reason), [f](const MotionState& s) { return f(s).value; },
            [f](const MotionState& s) { return f(s).size; }};
}

std::string energy_reason(const Model& model) {
    const bool others = has_forces(model);
    const std::string forces =
        others ? "gravity is constant, all other forces have a potential" : "gravity is constant";
    if (model.joints.empty()) return others ? forces : "no force but constant gravity acts";
    return forces + (others ? ", the joints do no work" : " and the joints do no work");
}

void add_energy(const Shared& model, std::vector<FirstIntegral>& integrals) {
    if (!is_conservative(*model) || std::any_of(model->joints.begin(), model->joints.end(), is_driven)) return;
    integrals.push_back(
        integral("energy", "J", energy_reason(*model), [model](const MotionState& s) { return energy(*model, s); }));
}

void add_angular_momenta(const Shared& model, std::vector<FirstIntegral>& integrals) {
    const Vec3 P = pivot(*model), g = model->gravity.g;
    const auto add = [&](const std::string& name, const Vec3& e, const char* reason) {
        const Line axis{P, e};
        if (!is_invariant_under_rotation(*model, axis)) return;
        const auto value = [model, axis](const MotionState& s) { return angular_momentum(*model, axis, s.bodies); };
        integrals.push_back(integral("angular_momentum_" + name, "N m s", reason, value));
    };
    if (!g.isZero(0)) {
        add("vertical", -g / g.norm(), "neither gravity nor the ground has a moment about this vertical");
        return;
    }
    for (int k = 0; k < 3; ++k) add(axis_names[k], Vec3::Unit(k), "the ground has no moment about this axis");
}

void add_momenta(const Shared& model, std::vector<FirstIntegral>& integrals) {
    for (int k = 0; k < 3; ++k) {
        const Vec3 e = Vec3::Unit(k);
        if (!is_invariant_under_translation(*model, e)) continue;
        integrals.push_back(integral(std::string("momentum_") + axis_names[k], "N s",
                                     "no external force acts along this axis",
                                     [model, e](const MotionState& s) { return momentum(*model, e, s.bodies); }));
    }
}

/// |J omega|, the Casimir of so(3)*: m = J omega moves on its coadjoint orbit, a sphere [hairer2006, Sec. VII.5].
Terms size_of_momentum(const Body& body, const BodyState& s) {
    Terms sum;
    sum.add((body.J * s.omega).norm());
    return sum;
}

void add_body_integrals(const Shared& model, std::vector<FirstIntegral>& integrals) {
    const std::vector<BodyTies> ties = ties_of_bodies(*model);
    for (std::size_t i = 0; i < model->bodies.size(); ++i) {
        const Body& body = model->bodies[i];
        const std::string suffix = model->bodies.size() > 1 ? "_" + body.name : "";
        if (const auto e = free_spin_axis(body, static_cast<int>(i), ties[i]))
            integrals.push_back(integral("body_momentum" + suffix, "N m s",
                                         "the body is symmetric about an axis along which no moment acts",
                                         [model, e = *e, i](const MotionState& s) {
                                             const Vec3 spin = model->bodies[i].J * s.bodies[i].omega;
                                             return Terms{e.dot(spin), spin.norm()};
                                         }));
        if (ties[i].none())  // gravity has no moment about its mass centre
            integrals.push_back(integral(
                "body_momentum_norm" + suffix, "N m s", "no moment acts on the body: the Casimir of its momentum",
                [model, i](const MotionState& s) { return size_of_momentum(model->bodies[i], s.bodies[i]); }));
        if (const auto top = kovalevskaya_top(body, static_cast<int>(i), ties[i], model->gravity))
            integrals.push_back(
                integral("kovalevskaya" + suffix, "1/s^4",
                         "a heavy top with A = B = 2 C and its mass centre in the plane of A and B",
                         [top = *top, i](const MotionState& s) { return kovalevskaya(top, s.bodies[i]); }));
    }
}

}  // namespace

std::vector<FirstIntegral> first_integrals(const Model& data) {
    const auto model = std::make_shared<const Model>(data);
    std::vector<FirstIntegral> integrals;
    add_energy(model, integrals);
    add_angular_momenta(model, integrals);
    add_momenta(model, integrals);
    add_body_integrals(model, integrals);
    return integrals;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
