// SPDX-License-Identifier: BSD-3-Clause
//
// Warnings about a start that is allowed: it is a singular position, the solves keep few digits, or axes of a
// torsion spring may part.
#include "mechanics/start_warnings.hpp"

#include <sstream>

#include "mechanics/formulation.hpp"
#include "mechanics/model/scales.hpp"
#include "mechanics/solve/joint_solver.hpp"
#include "mechanics/start.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int most_rows_examined = 120;

std::string two_digits(const Real& x) {
    std::ostringstream out;
    out.precision(2);
    out << to_double(x);
    return out.str();
}

ConstraintRank rank_at_start(const Model& model) {
    return JointSolver(model, SolverChoice::automatic).constraint_rank();
}

/// A force of the size of the masses, in no particular direction.
VecX some_force(const Model& model, int seed) {
    const std::vector<Real> lengths = body_lengths(model);
    VecX force(6 * static_cast<Eigen::Index>(lengths.size()));
    for (Eigen::Index i = 0; i < force.size(); ++i) {
        const auto body = static_cast<std::size_t>(i / 6);
        const Real pattern = cos(Real(static_cast<int>(i) * (seed + 2) + seed));
        force[i] =
            model.bodies[body].mass * pattern * (i % 6 < 3 ? extent(model) : Real(lengths[body] * lengths[body]));
    }
    return force;
}

/// A velocity of size 1 that the joints allow at the start, in no particular direction, of the formulation SO3xR3;
/// nothing where no motion is left.
std::optional<VecX> some_motion(const Model& model, System& system, const std::vector<Real>& y, int seed) {
    const VecX force = some_force(model, seed), still = VecX::Zero(system.constraints());
    VecX a(force.size());
    if (system.solve_kkt(0, y.data(), force.data(), still.data(), a.data(), nullptr) != Status::ok) return std::nullopt;
    Real largest = 0;
    for (Eigen::Index i = 0; i < a.size(); i += 6)
        largest = max(largest, max(Real(a.segment<3>(i).norm() / extent(model)), Real(a.segment<3>(i + 3).norm())));
    if (!(largest > sqrt(epsilon))) return std::nullopt;  // for forces of size 1: less is round-off
    return VecX(a / largest);
}

/// The model at rest beside its start, moved by about 1/64 as the joints allow, and projected back; nothing where no
/// motion is left, or the projection fails.
std::optional<Model> beside(Model model, int seed) {
    const auto system = formulation("SO3xR3").make(model);
    std::vector<Real> y = initial_state(*system, model);
    const std::optional<VecX> motion = some_motion(model, *system, y, seed);
    if (!motion) return std::nullopt;
    const VecX step = *motion / 64;
    system->group().append_exp(y.data(), step.data(), y.data());
    std::vector<BodyState> states(model.bodies.size());
    system->read(y.data(), states.data());
    for (std::size_t i = 0; i < states.size(); ++i) model.bodies[i].start = {states[i].x, states[i].R};
    try {
        project_start(model);
    } catch (const ParameterError&) { return std::nullopt; }
    return model;
}

/// Ratio of the masses of two bodies that a joint links, the largest of all, and which bodies they are.
std::string mass_ratio(const Model& model) {
    Real largest = 1;
    std::string who;
    for (const Joint& joint : model.joints) {
        if (joint.first == ground || joint.second == ground) continue;
        const Real &a = model.bodies[static_cast<std::size_t>(joint.first)].mass,
                   &b = model.bodies[static_cast<std::size_t>(joint.second)].mass;
        const Real ratio = max(Real(a / b), Real(b / a));
        if (ratio <= largest) continue;
        largest = ratio;
        who = "\"" + model.name_of(joint.first) + "\" and \"" + model.name_of(joint.second) + "\"";
    }
    return largest > 1000 ? "; the masses of " + who + " have a ratio of " + two_digits(largest) : "";
}

std::string of_conditioning(const Model& model, const Real& condition) {
    // A solve loses the square of the condition: S contains only the light body between a heavy one and the ground.
    const Real left = epsilon * condition * condition;
    if (left <= Real(1) / 1000000) return "";
    int digits = 0;
    for (Real share = Real(1) / 10; share > left; share /= 10) ++digits;
    return "constraint rows are nearly dependent in the metric of the masses: the pivots of M^(-1/2) C^T have a ratio "
           "of " +
           two_digits(condition) + ", so that accelerations and multipliers keep some " + std::to_string(digits) +
           " digits" + mass_ratio(model);
}

std::string of_singularity(const Model& model, const ConstraintRank& here) {
    if (here.rank == here.rows) return "";
    for (int seed = 0; seed < 2; ++seed) {
        const std::optional<Model> other = beside(model, seed);
        const int rank = other ? rank_at_start(*other).rank : here.rank;
        if (rank > here.rank)
            return "the start is a singular position: the rank of the constraints is " + std::to_string(here.rank) +
                   " there and " + std::to_string(rank) +
                   " beside it, so that more than one motion follows from it; solves beside it may end with "
                   "singular_kkt";
    }
    return "";
}

/// A vector in body axes, rotated to space axes by the start.
Vec3 turned(const Model& model, int body, const Vec3& vector) {
    return body == ground ? vector : Vec3(model.bodies[static_cast<std::size_t>(body)].start.R * vector);
}

/// Angular velocity of a body in space axes, of a velocity of the formulation SO3xR3.
Vec3 turning(const Model& model, const VecX& motion, int body) {
    return body == ground ? Vec3(Vec3::Zero()) : turned(model, body, motion.segment<3>(6 * body + 3));
}

/// Springs whose axes the joints allow to part.
std::vector<std::string> of_springs(const Model& model) {
    std::vector<std::string> warnings;
    if (model.torsion_springs.empty()) return warnings;
    const auto system = formulation("SO3xR3").make(model);
    const std::optional<VecX> motion = some_motion(model, *system, initial_state(*system, model), 0);
    for (std::size_t i = 0; motion && i < model.torsion_springs.size(); ++i) {
        const TorsionSpring& spring = model.torsion_springs[i];
        const Vec3 axis = turned(model, spring.second, spring.axes_second.col(2));
        const Vec3 relative = turning(model, *motion, spring.second) - turning(model, *motion, spring.first);
        if (relative.cross(axis).norm() > sqrt(epsilon))
            warnings.push_back(
                model.name_of_torsion_spring(i) +
                ": the joints do not keep its axes parallel: a run ends with turn_lost where they part so far "
                "that a turn is not defined");
    }
    return warnings;
}

}  // namespace

std::vector<std::string> start_warnings(const Model& model) {
    std::vector<std::string> warnings = of_springs(model);
    int rows = 0;
    for (const Joint& joint : model.joints) rows += rows_of(joint.type);
    if (rows == 0 || rows > most_rows_examined) return warnings;
    const ConstraintRank rank = rank_at_start(model);
    for (const std::string& warning : {of_singularity(model, rank), of_conditioning(model, rank.condition.value_or(1))})
        if (!warning.empty()) warnings.push_back(warning);
    return warnings;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
