// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/QR>
#include <sstream>

#include "mechanics/formulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::string name_of(const Model& model, int body) {
    return body == ground ? "ground" : model.bodies[static_cast<std::size_t>(body)].name;
}

/// "joint 1 (upper - lower): 0.02" for each joint.
std::string residuals_by_joint(const Model& model, const VecX& residual, const char* unit) {
    std::ostringstream out;
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
        const SphericalJoint& joint = model.joints[j];
        const Real size = residual.segment<3>(3 * static_cast<Eigen::Index>(j)).norm();
        out << (j > 0 ? ", " : "") << "joint " << j << " (" << name_of(model, joint.first) << " - "
            << name_of(model, joint.second) << "): " << to_double(size) << ' ' << unit;
    }
    return out.str();
}

void require_small(const Model& model, const VecX& residual, const Real& size, const char* level, const char* unit) {
    if (residual.norm() * 1000000000 <= size) return;
    throw ParameterError("", std::string("the start violates the joints at ") + level +
                                 " level; residual of each: " + residuals_by_joint(model, residual, unit));
}

}  // namespace

void check_start(const Model& model) {
    if (model.joints.empty()) return;
    const auto system = make_system(model, "SO3xR3");
    const std::vector<Real> y = initial_state(*system, model);
    const Real* v = y.data() + system->group().size();
    const Eigen::Index m = system->constraints(), n = system->velocities();
    Real length = 0, speed = 1;
    for (const Body& body : model.bodies) speed = max(speed, Real(body.start.v.norm()));
    for (const SphericalJoint& joint : model.joints) length = max(length, max(Real(joint.r_first.norm()), Real(joint.r_second.norm())));

    VecX residual(m);
    system->position_residual(0, y.data(), residual.data());
    require_small(model, residual, length > 0 ? length : Real(1), "position", "m");
    system->velocity_residual(0, y.data(), v, residual.data());
    require_small(model, residual, speed, "velocity", "m/s");

    MatX C(m, n);
    system->jacobian(0, y.data(), C.data());
    const auto rank = C.colPivHouseholderQr().rank();
    if (rank < m)
        throw ParameterError("", "redundant joints: the " + std::to_string(m) + " constraint rows have rank " +
                                     std::to_string(rank) + " in the initial configuration");
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
