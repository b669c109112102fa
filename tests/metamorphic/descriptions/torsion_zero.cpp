// SPDX-License-Identifier: BSD-3-Clause
//
// Where the angle of a torsion spring is zero: its first frame turned back about the axis by almost half a turn, and
// the rest angle with it. A spring that loses full turns then loses them elsewhere.
#include "lie/so3.hpp"
#include "mechanics/forces/forces.hpp"
#include "tests/metamorphic/descriptions/transformation.hpp"
#include "tests/metamorphic/models/motion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

std::optional<Transformed> moved_zero(const Model& model) {
    if (model.torsion_springs.empty()) return {};
    const Real shift = Real(9) / 4;
    std::vector<BodyState> starts;
    for (const Body& body : model.bodies) starts.push_back(body.start);
    Model changed = model;
    for (TorsionSpring& spring : changed.torsion_springs) {
        const Turn now = turn(spring, motion_of(starts, spring.first), motion_of(starts, spring.second));
        if (now.principal + shift > pi()) ++spring.turns;  // past half a turn the next one begins
        spring.axes_first = spring.axes_first * SO3::exp(-shift * Vec3::UnitZ());
        spring.angle += shift;
    }
    return Transformed{changed, 1, 1, false, [](const Outcome& outcome) { return outcome; }};
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
