// SPDX-License-Identifier: BSD-3-Clause
#include "engine/begin.hpp"

#include <map>
#include <set>

#include "engine/report/report.hpp"
#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"
#include "mechanics/model/scales.hpp"
#include "support/number_text.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::string listed(const std::set<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "\"" : ", \"") + name + "\"";
    return list.empty() ? "none" : list;
}

std::string objection(const char* what, const std::set<std::string>& expected, const std::set<std::string>& got) {
    if (expected == got) return "";
    return std::string("expected a state of this mechanism, with the ") + what + " " + listed(expected) + ", got " +
           listed(got);
}

BodyState state_of(const ReportedBody& body) {
    ReportedState alone;
    alone.bodies = {body};
    return from_report(alone).front();
}

/// Norms over the rows that are lengths.
Real norm_of_lengths(const std::vector<ConstraintRow>& rows, const std::vector<Real>& residual) {
    Real sum = 0;
    for (std::size_t i = 0; i < residual.size(); ++i)
        if (!rows[i].direction) sum += residual[i] * residual[i];
    return sqrt(sum);
}

/// What speeds of a mechanism are small against.
Real speed_of(const Model& model) {
    Real speed = 0;
    for (const Body& body : model.bodies)
        speed = max(speed, max(Real(body.start.v.norm()), Real(body.start.omega.norm() * extent(model))));
    return speed;
}

void measure_drift(const Model& model, const System& system, const Real& t, const std::vector<Real>& y,
                   BeginCheck& check) {
    const auto rows = system.constraint_rows();
    std::vector<Real> phi(static_cast<std::size_t>(system.position_constraints())),
        rate(static_cast<std::size_t>(system.constraints()));
    system.position_residual(t, system.q(y.data()), phi.data());
    system.velocity_residual(t, system.q(y.data()), system.v(y.data()), rate.data());
    const Real position = norm_of_lengths(rows, phi), velocity = norm_of_lengths(rows, rate);
    const Real small = Real(1) / 1000000000000;
    check.drifts = position > small * extent(model) || velocity > small * speed_of(model);
    check.position = to_double(position), check.velocity = to_double(velocity);
}

/// How far what a state space holds is from what it was given, each quantity over what it may be off.
struct Quantity {
    const char* name;
    const char* unit;
    Real off, scale;
};

std::string misfit(const Model& model, const std::vector<BodyState>& held) {
    const Real size = extent(model), speed = speed_of(model);
    Real rate = 0;
    for (const Body& body : model.bodies) rate = max(rate, Real(body.start.omega.norm()));
    for (std::size_t i = 0; i < held.size(); ++i) {
        const BodyState &has = held[i], &given = model.bodies[i].start;
        const Quantity quantities[] = {{"x", "m", (has.x - given.x).norm(), size},
                                       {"R", "", (has.R - given.R).norm(), 1},
                                       {"v", "m/s", (has.v - given.v).norm(), speed},
                                       {"omega", "rad/s", (has.omega - given.omega).norm(), rate}};
        for (const Quantity& one : quantities) {
            if (model.bodies[i].point && (one.name[0] == 'R' || one.name[0] == 'o')) continue;
            if (one.off <= one.scale / 1000000000) continue;
            return std::string("the nearest to ") + one.name + " of body \"" + model.bodies[i].name +
                   "\" that it holds is " + brief_text(to_double(one.off)) + (*one.unit ? " " : "") + one.unit +
                   " away";
        }
    }
    return "";
}

std::string not_a_rotation(const Model& model) {
    for (const Body& body : model.bodies) {
        const Real defect = SO3::orthogonality_defect(body.start.R);
        if (body.point || (defect <= Real(1) / 10 && body.start.R.determinant() > 0)) continue;
        return "expected a rotation R of body \"" + body.name +
               "\", got |R^T R - I| = " + brief_text(to_double(defect));
    }
    return "";
}

}  // namespace

std::string why_not_of(const Model& model, const BeginState& begin) {
    std::set<std::string> bodies, springs, given, turned;
    for (const Body& body : model.bodies) bodies.insert(body.name);
    for (const std::string& spring : names_of_torsion_springs(model)) springs.insert(spring);
    for (const ReportedBody& body : begin.bodies) given.insert(body.name);
    for (const auto& [name, turns] : begin.turns) turned.insert(name);
    const std::string reason = objection("bodies", bodies, given);
    return reason.empty() ? objection("torsion springs", springs, turned) : reason;
}

Model moved_to(Model model, const BeginState& begin) {
    std::map<std::string, const ReportedBody*> given;
    for (const ReportedBody& body : begin.bodies) given[body.name] = &body;
    for (Body& body : model.bodies) body.start = state_of(*given.at(body.name));
    const auto springs = names_of_torsion_springs(model);
    for (std::size_t i = 0; i < springs.size(); ++i) model.torsion_springs[i].turns = begin.turns.at(springs[i]);
    return model;
}

BeginCheck checked_begin(const Model& model, const std::string& formulation, const BeginState& begin) {
    if (std::string reason = why_not_of(model, begin); !reason.empty()) return {std::move(reason)};
    const Model moved = moved_to(model, begin);
    if (std::string reason = not_a_rotation(moved); !reason.empty()) return {std::move(reason)};
    const auto system = make_system(model, formulation);
    const std::vector<Real> y = initial_state(*system, moved);
    std::vector<BodyState> held(model.bodies.size());
    system->read(y.data(), held.data());
    BeginCheck check;
    if (const std::string reason = misfit(moved, held); !reason.empty()) {
        check.fault = "expected a state that formulation " + formulation + " holds: " + reason;
        return check;
    }
    const Real t = from_number(begin.t);
    measure_drift(moved, *system, t, y, check);
    if (system->begin_step(t, 0, y.data()) != Status::ok) check.fault = system->reason(Status::turn_lost);
    return check;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
