// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/start.hpp"

#include <Eigen/QR>
#include <algorithm>

#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"
#include "mechanics/start/least_correction.hpp"
#include "mechanics/start/positions.hpp"
#include "mechanics/start/start_state.hpp"
#include "mechanics/start/start_tolerances.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Throws where the axes of a torsion spring have parted so far that its turns have no meaning.
void check_springs(const Model& model) {
    if (model.torsion_springs.empty()) return;
    const auto system = formulation(StartState::coordinates).make(model);
    const std::vector<Real> y = initial_state(*system, model);
    if (system->begin_step(0, 0, y.data()) != Status::ok) throw ParameterError("", system->reason(Status::turn_lost));
}

StartCorrection largest_change(const Model& model, const std::vector<BodyState>& states) {
    StartCorrection moved;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const BodyState& old = model.bodies[i].start;
        moved.position = max(moved.position, Real((states[i].x - old.x).norm()));
        moved.rotation = max(moved.rotation, Real(SO3::log(old.R.transpose() * states[i].R).norm()));
        moved.velocity = max(moved.velocity, Real((states[i].v - old.v).norm()));
        moved.omega = max(moved.omega, Real((states[i].omega - old.omega).norm()));
    }
    return moved;
}

}  // namespace

void check_start(const Model& model) {
    check_springs(model);
    if (model.joints.empty()) return;
    StartState start(model);
    require_positions(start);
    require_velocities(start);
    System& system = start.system();
    std::vector<Real> dv(static_cast<std::size_t>(system.velocities()));
    if (system.accelerations(0, start.q(), start.v(), dv.data(), nullptr) == Status::singular_kkt)
        throw ParameterError("", "the joints contradict each other in the initial configuration, or lose rank there: " +
                                     system.reason(Status::singular_kkt));
}

StartCorrection project_start(Model& model) {
    if (model.joints.empty()) return {};
    const Model aligned = with_aligned_axes(model);
    StartState start(aligned);
    project_positions(start);
    require_positions(start);
    const Real speed = start.speed();
    for (int i = 0; i < 2; ++i) start.velocities() += least_correction(start, start.rows(), start.velocity_residual());
    stop_noise(start, speed);
    std::vector<BodyState> states(model.bodies.size());
    start.system().read(start.q(), states.data());
    StartCorrection moved = largest_change(model, states);
    moved.noise = is_noise(start, moved);
    require_velocities(start);
    for (std::size_t i = 0; i < states.size(); ++i) model.bodies[i].start = states[i];
    return moved;
}

namespace {

/// Both rigid and point bodies have six columns.
std::vector<bool> unknown_columns(const GivenVelocities& given) {
    std::vector<bool> unknown;
    for (std::size_t i = 0; i < given.v.size(); ++i) {
        unknown.insert(unknown.end(), 3, !given.v[i]);
        unknown.insert(unknown.end(), 3, !given.omega[i]);
    }
    return unknown;
}

/// Says which velocities nothing determines, unless all is at rest.
void warn_of_freedom(Model& model, const LeastCorrection& last, const Real& speed) {
    if (last.free == 0 || speed == 0) return;
    std::string bodies;
    for (std::size_t i = 0; i < model.bodies.size(); ++i)
        if (last.freedom.segment<6>(6 * static_cast<Eigen::Index>(i)).maxCoeff() > sqrt(epsilon))
            bodies += (bodies.empty() ? "\"" : ", \"") + model.bodies[i].name + "\"";
    model.warnings.push_back("what is given and the joints leave " + std::to_string(last.free) +
                             " directions free in the velocities of " + bodies +
                             ": those of least kinetic energy are taken");
}

}  // namespace

void complete_velocities(Model& model, const GivenVelocities& given) {
    if (std::find(given.omega.begin(), given.omega.end(), false) == given.omega.end())
        return complete_velocities(model, given.v);
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        if (!given.v[i]) model.bodies[i].start.v.setZero();
        if (!given.omega[i]) model.bodies[i].start.omega.setZero();
    }
    if (model.joints.empty()) return;
    StartState start(model);
    const std::vector<bool> unknown = unknown_columns(given);
    LeastCorrection last;
    for (int i = 0; i < 2; ++i) {
        last = least_correction(start, start.rows(), start.velocity_residual(), unknown);
        start.velocities() += last.change;
    }
    stop_noise(start, start.speed());
    std::vector<BodyState> states(model.bodies.size());
    start.system().read(start.q(), states.data());
    const Real speed = start.speed();
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (!given.v[i]) model.bodies[i].start.v = states[i].v;
        if (!given.omega[i]) model.bodies[i].start.omega = states[i].omega;
    }
    warn_of_freedom(model, last, speed);
}

void complete_velocities(Model& model, const std::vector<bool>& given) {
    std::vector<Eigen::Index> unknown;  // columns of x' of bodies without a given velocity
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i]) continue;
        model.bodies[i].start.v.setZero();
        for (Eigen::Index k = 0; k < 3; ++k) unknown.push_back(6 * static_cast<Eigen::Index>(i) + k);
    }
    if (unknown.empty() || model.joints.empty()) return;
    StartState start(model);
    // Rows that compare directions do not depend on x', and their residuals have another unit.
    const std::vector<Eigen::Index> rows = start.length_rows();
    const MatX C = start.jacobian();
    const VecX residual = start.velocity_residual();
    MatX columns(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(unknown.size()));
    VecX wanted(columns.rows());
    for (Eigen::Index i = 0; i < columns.rows(); ++i) {
        const Eigen::Index row = rows[static_cast<std::size_t>(i)];
        wanted[i] = -residual[row];
        for (Eigen::Index k = 0; k < columns.cols(); ++k) columns(i, k) = C(row, unknown[static_cast<std::size_t>(k)]);
    }
    const VecX v = columns.completeOrthogonalDecomposition().solve(wanted);
    for (Eigen::Index k = 0; k < v.size(); ++k) {
        const Eigen::Index column = unknown[static_cast<std::size_t>(k)];
        model.bodies[static_cast<std::size_t>(column / 6)].start.v[column % 6] = v[k];
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
