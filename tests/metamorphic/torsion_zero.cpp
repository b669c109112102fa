// SPDX-License-Identifier: BSD-3-Clause
//
// Where the angle of a torsion spring is zero: its first frame turned back about the axis by most of half a turn, and the rest
// angle with it. A spring that forgets full turns forgets them elsewhere then.
#include "lie/so3.hpp"
#include "tests/metamorphic/transformation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

std::optional<Transformed> moved_zero(const Model& model) {
    if (model.torsion_springs.empty()) return {};
    const Real shift = Real(9) / 4;
    Model changed = model;
    for (TorsionSpring& spring : changed.torsion_springs) {
        spring.axes_first = spring.axes_first * SO3::exp(-shift * Vec3::UnitZ());
        spring.angle += shift;
    }
    return Transformed{changed, 1, 1, false, [](const Outcome& outcome) { return outcome; }};
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
