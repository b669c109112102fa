// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/start/start_tolerances.hpp"

#include <sstream>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// By how much of its scale a start may violate a row: data have about ten digits.
const Real tolerance = Real(1) / 1000000000;
/// Round-off of data that came through double precision, relative to distances from the origin and to speeds; and
/// the round-off of arithmetic on them.
const Real data_round_off = Real(1) / 281474976710656, noise = Real(1) / 10000000000000;

/// "joint 1 (upper - lower, spherical): 0.02 m" for each joint; rows that compare directions have no length.
std::string by_joint(const StartState& start, const VecX& residual, const char* second) {
    const Model& model = start.model();
    std::vector<Real> lengths(model.joints.size(), 0), directions = lengths;
    start.each_row([&](std::size_t joint, int k, Eigen::Index row) {
        (is_direction_row(model.joints[joint].type, k) ? directions : lengths)[joint] += residual[row] * residual[row];
    });
    std::ostringstream out;
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
        out << (j > 0 ? ", " : "") << model.name_of_joint(j) << ": " << to_double(sqrt(lengths[j])) << " m" << second;
        if (has_direction_rows(model.joints[j].type))
            out << " and " << to_double(sqrt(directions[j])) << (*second ? " 1" : "") << second;
    }
    return out.str();
}

/// "; joint 0 (ground - crank, revolute with driven turn): expected a turn of 0.3 rad, got 0 rad" for each prescribed
/// coordinate that the start violates; of velocities with `second`.
std::string by_drive(const StartState& start, const VecX& residual, const VecX& allowed, const std::string& second) {
    std::ostringstream out;
    start.each_row([&](std::size_t j, int k, Eigen::Index row) {
        const Joint& joint = start.model().joints[j];
        const bool turns = k == joint.type->row_of(Primitive::turn), slides = k == joint.type->row_of(Primitive::shift);
        if ((!turns && !slides) || abs(residual[row]) <= allowed[row]) return;
        const Prescribed::Value law = (turns ? joint.turn : joint.shift).at(0);
        const Real expected = second.empty() ? law.f : law.rate;
        const Real got = expected - residual[row];
        const std::string unit = (turns ? " rad" : " m") + second;
        out << "; " << start.model().name_of_joint(j) << ": expected a " << (turns ? "turn" : "shift") << " of "
            << to_double(expected) << unit << ", got " << to_double(got) << unit;
    });
    return out.str();
}

/// `second`: what a velocity row has in its unit behind that of a position row.
void require(const StartState& start, const VecX& residual, const VecX& allowed, const char* level,
             const char* second) {
    if ((residual.cwiseAbs().array() <= allowed.array()).all()) return;
    throw ParameterError("", std::string("the start violates the joints at ") + level + " level; residual of each: " +
                                 by_joint(start, residual, second) + by_drive(start, residual, allowed, second));
}

}  // namespace

void require_positions(StartState& start) {
    require(start, start.position_residual(), tolerance * start.scale() + data_round_off * start.position_terms(),
            "position", "");
}

void require_velocities(StartState& start) {
    VecX allowed = tolerance * start.rate() * start.scale();
    const Real round_off = data_round_off * start.speed_round_off();
    for (const Eigen::Index row : start.length_rows()) allowed[row] += round_off;
    require(start, start.velocity_residual(), allowed, "velocity", "/s");
}

bool is_round_off(StartState& start, const VecX& phi) {
    return (phi.cwiseAbs().array() <= epsilon * start.position_terms().array()).all();
}

bool is_noise(StartState& start, const StartCorrection& moved) {
    const Real &size = start.size(), &place = start.place();
    const Real apart = size > 0 ? Real(1 + place / size) : Real(1);
    return moved.position <= noise * max(size, place) && moved.rotation <= noise * apart &&
           moved.velocity <= noise * max(Real(start.rate() * size), start.speed_round_off()) &&
           moved.omega <= noise * start.rate() * apart;
}

void stop_noise(StartState& start, const Real& speed_before) {
    if (start.speed() <= noise * speed_before) start.velocities().setZero();
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
