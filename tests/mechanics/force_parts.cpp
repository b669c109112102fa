// SPDX-License-Identifier: BSD-3-Clause
//
// The conservative and the dissipative part of the applied force, against models that have one of them only.
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

/// Without what depends on velocities.
Model undamped(Model model) {
    for (Spring& spring : model.springs) spring.damping = 0;
    for (TorsionSpring& spring : model.torsion_springs) spring.damping = 0;
    for (PolynomialSpring& spring : model.polynomial_springs) spring.damping = 0;
    for (Bushing& bushing : model.bushings) bushing.damping = {Vec3::Zero(), Vec3::Zero()};
    model.dampers.clear(), model.rotational_dampers.clear();
    return model;
}

/// Without what acts at rest.
Model dampers_of(Model model) {
    model.gravity.g.setZero();
    model.loads.clear();
    for (Spring& spring : model.springs) spring.stiffness = 0;
    for (TorsionSpring& spring : model.torsion_springs) spring.stiffness = 0;
    for (PolynomialSpring& spring : model.polynomial_springs) spring.coefficients.clear();
    for (Bushing& bushing : model.bushings) bushing.stiffness = {Vec3::Zero(), Vec3::Zero()};
    model.attractions.clear();
    return model;
}

struct Parts {
    VecX applied, conservative, dissipative;
};

/// At the pose in which `at` starts, moving somehow.
Parts parts_of(const Model& model, const std::string& formulation, const Model& at) {
    const auto s = make_system(model, formulation);
    const std::vector<Real> y = initial_state(*s, at);
    const Eigen::Index n = s->velocities();
    const Real t = Real(3) / 10;
    VecX v(n);
    for (Eigen::Index i = 0; i < n; ++i) v[i] = sin(2 * Real(i + 1));
    Parts parts{VecX(n), VecX(n), VecX(n)};
    s->applied_force(t, y.data(), v.data(), parts.applied.data());
    s->conservative_force(t, y.data(), parts.conservative.data());
    s->dissipative_force(t, y.data(), v.data(), parts.dissipative.data());
    return parts;
}

}  // namespace

TEST_CASE("each part of the applied force is all that acts without the other", "[mechanics][forces]") {
    int dissipative = 0;
    for (const Named& named : all())
        for (const std::string& formulation : applicable(named.model)) {
            INFO(named.name << " as " << formulation);
            const Parts both = parts_of(named.model, formulation, named.model);
            const Parts elastic = parts_of(undamped(named.model), formulation, named.model);
            const Parts damping = parts_of(dampers_of(named.model), formulation, named.model);
            CHECK(both.conservative == elastic.applied);
            CHECK(both.dissipative == damping.applied);
            CHECK(elastic.dissipative.isZero(0));
            CHECK(damping.conservative.isZero(0));
            if (!both.dissipative.isZero(0)) ++dissipative;
        }
    CHECK(dissipative > 20);
}
