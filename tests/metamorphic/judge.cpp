// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/judge.hpp"

#include <Eigen/QR>

#include "mechanics/formulation.hpp"
#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/model/scales.hpp"
#include "mechanics/solve/rank.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

using namespace growing;

namespace {

std::string of_body(const Model& model, std::size_t i, const char* quantity) {
    return std::string(quantity) + " of " + model.bodies[i].name;
}

/// Calls see(difference, effect, name) for every quantity of a pair, one after another, until it returns false.
template <class See>
void each_difference(const RunPair& pair, const Model& model, See see) {
    const Outcome &a = pair.original, &b = pair.changed;
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        const BodyState &s = a.bodies[i], &r = b.bodies[i];
        if (!see((s.x - r.x).norm(), on_position, of_body(model, i, "x"))) return;
        if (!see((s.R - r.R).norm(), on_rotation, of_body(model, i, "R"))) return;
        if (!see((s.v - r.v).norm(), on_velocity, of_body(model, i, "v"))) return;
        if (!see((s.omega - r.omega).norm(), on_omega, of_body(model, i, "omega"))) return;
    }
    for (std::size_t i = 0; i < a.totals.size(); ++i) {
        if (!see((a.totals[i].force - b.totals[i].force).norm(), on_force, of_body(model, i, "force of all joints")))
            return;
        if (!see((a.totals[i].torque - b.totals[i].torque).norm(), on_torque,
                 of_body(model, i, "torque of all joints")))
            return;
    }
    const std::vector<bool> unique = unique_joints(model);
    for (std::size_t j = 0; j < a.joints.size(); ++j)
        for (const std::size_t side : {0u, 1u}) {
            if (!unique[j]) continue;
            const Action &p = a.joints[j][side], &q = b.joints[j][side];
            if (!see((p.force - q.force).norm(), on_force, "force of " + model.name_of_joint(j))) return;
            if (!see((p.torque - q.torque).norm(), on_torque, "torque of " + model.name_of_joint(j))) return;
        }
}

Real heaviest(const Model& model) {
    Real mass = 0;
    for (const Body& body : model.bodies) mass = max(mass, body.mass);
    return mass;
}

/// The momentum about a body's axis, whose sign is arbitrary, by its size.
Real without_sense(const std::string& name, const Real& value) {
    return name.starts_with("body_momentum") ? Real(abs(value)) : value;
}

/// The integrals of one outcome that the other lacks.
std::string missing(const std::map<std::string, Real>& from, const std::map<std::string, Real>& in) {
    for (const auto& [name, value] : from)
        if (!in.contains(name)) return name;
    return "";
}

}  // namespace

RunPair run_both(const Model& model, const Transformed& transformed, const Combination& combination, const Span& span,
                 const Bench& bench) {
    const Span changed{span.h * transformed.time, span.steps, transformed.restart};
    return {run(model, combination, span, bench),
            transformed.back(run(transformed.model, combination, changed, bench))};
}

std::string difference_in_bits(const RunPair& pair, const Model& model) {
    if (pair.original.failure != pair.changed.failure)
        return "status \"" + pair.original.failure + "\" and \"" + pair.changed.failure + "\"";
    std::string found;
    each_difference(pair, model, [&](const Real& difference, Effect, const std::string& name) {
        if (difference != 0 && isfinite(difference)) found = name + " by " + to_text(difference);
        return found.empty();
    });
    if (!found.empty()) return found;
    for (const auto& [name, value] : pair.original.integrals) {
        const auto other = pair.changed.integrals.find(name);
        if (other == pair.changed.integrals.end()) return "the integral " + name + " is not found again";
        const Real difference = without_sense(name, value) - without_sense(name, other->second);
        if (difference != 0) return name + " by " + to_text(difference);
    }
    const std::string fresh = missing(pair.changed.integrals, pair.original.integrals);
    return fresh.empty() ? "" : "the integral " + fresh + " is new";
}

Allowance allowance(const Model& model, const Sizes& sizes, const Real& largest_x, const Growth& growth,
                    const Real& h) {
    const Real D = extent(model), rate = fastest_rate(model), mass = heaviest(model);
    const Real far = max(largest_x, D);
    Real speed = max(sizes.v, D * rate), turn = max(sizes.omega, rate),
         force = max(sizes.force, mass * D * rate * rate);
    Real angle = 1;
    if (h > 0) {
        angle = far / D;
        speed = max(speed, far / h), turn = max(turn, angle / h), force = max(force, mass * far / (h * h));
    }
    const Real torque = max(sizes.torque, force * D);
    const Real start[causes] = {far, angle, speed, turn}, own[effects] = {far, angle, speed, turn, force, torque};
    Real grown[effects];
    for (std::size_t effect = 0; effect < effects; ++effect) {
        grown[effect] = own[effect];
        Real sum = 0;
        for (std::size_t cause = 0; cause < causes; ++cause) sum += Real(growth[effect][cause]) * start[cause];
        grown[effect] = max(grown[effect], sum);
    }
    return {grown[on_position], grown[on_rotation], grown[on_velocity],
            grown[on_omega],    grown[on_force],    grown[on_torque]};
}

Excess excess(const RunPair& pair, const Model& model, const Allowance& allowance, int steps) {
    Excess worst;
    const Real unit = epsilon * steps;
    const auto compare = [&](const Real& difference, const Real& allowed, const std::string& name) {
        const Real ratio = difference / (unit * allowed);
        if (!(ratio <= worst.ratio)) worst = {ratio, name + " by " + to_text(difference)};
        return true;
    };
    each_difference(pair, model, [&](const Real& difference, Effect effect, const std::string& name) {
        const Real allowed[effects] = {allowance.position, allowance.rotation, allowance.velocity,
                                       allowance.omega,    allowance.force,    allowance.torque};
        return compare(difference, allowed[effect], name);
    });
    const Real mass = heaviest(model) * static_cast<int>(model.bodies.size());
    const Real momentum = mass * allowance.velocity, D = extent(model);
    for (const auto& [name, value] : pair.original.integrals) {
        const auto other = pair.changed.integrals.find(name);
        if (other == pair.changed.integrals.end()) continue;
        const Real length = name.starts_with("momentum_") ? Real(1) : max(allowance.position, D);
        const bool energy = name == "energy";
        if (name.starts_with("kovalevskaya")) continue;
        compare(abs(without_sense(name, value) - without_sense(name, other->second)),
                energy ? max(Real(momentum * allowance.velocity), allowance.force * length) : Real(momentum * length),
                name);
    }
    return worst;
}

std::vector<bool> unique_joints(const Model& model) {
    std::vector<bool> unique(model.joints.size(), true);
    const auto system = make_system(model, "SO3xR3");
    const ConstraintRank rank = system->constraint_rank();
    if (rank.rank == rank.rows) return unique;
    const std::vector<Real> y = initial_state(*system, model);
    MatX C(system->constraints(), system->velocities());
    system->jacobian(0, y.data(), C.data());
    const MatX columns = MatX(C.transpose()).colwise().normalized();
    const RowChoice choice = choose_rows(columns, rank.rank);
    std::vector<std::size_t> joint_of(static_cast<std::size_t>(columns.cols()));
    std::size_t position = 0, velocity = static_cast<std::size_t>(system->position_constraints());
    for (std::size_t j = 0; j < model.joints.size(); ++j)
        for (int k = 0; k < rows_of(model.joints[j].type); ++k)
            joint_of[k < position_rows_of(model.joints[j].type) ? position++ : velocity++] = j;
    MatX kept(columns.rows(), rank.rank);
    std::vector<std::size_t> places;
    for (Eigen::Index c = 0; c < columns.cols(); ++c)
        if (choice.independent[static_cast<std::size_t>(c)])
            kept.col(static_cast<Eigen::Index>(places.size())) = columns.col(c),
            places.push_back(static_cast<std::size_t>(c));
    const Eigen::ColPivHouseholderQR<MatX> qr(kept);
    for (Eigen::Index c = 0; c < columns.cols(); ++c) {
        if (choice.independent[static_cast<std::size_t>(c)]) continue;
        unique[joint_of[static_cast<std::size_t>(c)]] = false;
        const VecX combination = qr.solve(columns.col(c));
        for (std::size_t k = 0; k < places.size(); ++k)
            if (abs(combination[static_cast<Eigen::Index>(k)]) > dependence) unique[joint_of[places[k]]] = false;
    }
    return unique;
}

Real distance(const Outcome& a, const Outcome& b, const Model& model) {
    const Real D = extent(model), rate = fastest_rate(model);
    Real worst = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        const BodyState &s = a.bodies[i], &r = b.bodies[i];
        worst = max(worst, max(Real((s.x - r.x).norm() / D), Real((s.R - r.R).norm())));
        worst = max(worst, max(Real((s.v - r.v).norm() / (D * rate)), Real((s.omega - r.omega).norm() / rate)));
    }
    return worst;
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
