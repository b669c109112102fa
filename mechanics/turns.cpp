// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/turns.hpp"

#include <sstream>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const Real half_turn = pi(), full_turn = 2 * pi();

Real floor_of(const Real& x) {
    using std::floor;
    return floor(x);
}

/// Full turns between an angle and its representative nearest to another.
Real turns_to(const Real& angle, const Real& near) { return floor_of((near - angle) / full_turn + Real(1) / 2); }

std::string six_digits(const Real& x) {
    std::ostringstream out;
    out << to_double(x);  // six digits
    return out.str();
}

}  // namespace

Real nearest_turn(const Real& angle, const Real& near) { return angle + full_turn * turns_to(angle, near); }

SpringAngle Turns::counted(const Real& principal, const Real& near) {
    const Real turns = turns_to(principal, near);
    const bool countable = abs(turns) < Real(1L << 62);  // false for NaN
    return {principal + full_turn * turns, countable ? static_cast<long>(turns) : 0};
}

std::shared_ptr<const Group> configurations(std::shared_ptr<const Group> poses, const Model& model) {
    if (model.torsion_springs.empty()) return poses;
    return std::make_shared<Covering>(std::move(poses), static_cast<int>(model.torsion_springs.size()));
}

/// Comparisons with NaN are false: the solver detects it by itself.
void Turns::judge(std::size_t spring, const Turn& turn, const Real& distance) const {
    const bool finite = isfinite(Real(turn.rate + distance));
    const Real turning = abs(h_ * turn.rate);
    if (2 * turn.shadow < 1)
        fault_ = {Fault::parted, spring, turn.shadow};
    else if (stepping_ && finite && turning >= half_turn)
        fault_ = {Fault::fast, spring, turning};
    else if (stepping_ && finite && 2 * abs(distance) > half_turn)
        fault_ = {Fault::far, spring, abs(distance)};
}

std::string Turns::reason() const {
    if (fault_.kind == Fault::none) return "";
    const std::string who = model_.name_of_torsion_spring(fault_.spring);
    if (fault_.kind == Fault::parted)
        return who + " has axes that part: perpendicular to the first, a unit vector of the second body is " +
               six_digits(fault_.size) + " long, and below 0.5 full turns are not defined";
    if (fault_.kind == Fault::fast)
        return who + " turns by " + six_digits(fault_.size) +
               " rad in a step, where full turns are counted below pi only";
    return who + " is " + six_digits(fault_.size) +
           " rad from where its rate at the start of the step leads, and full turns are counted up to pi/2 only";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
