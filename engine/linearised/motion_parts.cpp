// SPDX-License-Identifier: BSD-3-Clause
#include "engine/linearised/motion_parts.hpp"

#include "engine/linearised/spectrum.hpp"
#include "engine/report/report.hpp"
#include "mechanics/model/scales.hpp"
#include "support/number_text.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// "(0, 0, 1)"; what is round-off of the unit is zero.
std::string in_brackets(const Vec3& a, const Real& unit) {
    std::string text;
    for (int i = 0; i < 3; ++i) {
        const double x = abs(a[i]) <= same_eigenvalue(unit) ? 0 : to_double(a[i]);
        text += (i > 0 ? ", " : "(") + brief_text(x);
    }
    return text + ")";
}

std::string direction(const Vec3& a) { return in_brackets(a.normalized(), 1); }

}  // namespace

std::vector<MotionPart> motion_parts(const Model& model, const Generator& c, const Real& rate) {
    const Real size = extent(model), length = size > 0 ? size : Real(1), least = same_eigenvalue(rate);
    std::vector<MotionPart> parts;
    Vec3 shift = c.u;
    if (c.w.norm() > least) {
        const Vec3 e = c.w.normalized(), P = c.w.cross(c.u) / c.w.squaredNorm();
        parts.push_back({"rotation about " + direction(c.w) + " through " + in_brackets(P, length),
                         to_number(c.w.norm()), "rad/s"});
        shift = e.dot(c.u) * e;  // that of a screw
    }
    if (shift.norm() > least * length)
        parts.push_back({"translation along " + direction(shift), to_number(shift.norm()), "m/s"});
    for (std::size_t i = 0; i < c.spins.size(); ++i)
        if (c.spins[i].norm() > least)
            parts.push_back({"spin of " + model.bodies[i].name + " about " + direction(c.spins[i]),
                             to_number(c.spins[i].norm()), "rad/s"});
    return parts;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
