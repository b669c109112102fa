// SPDX-License-Identifier: BSD-3-Clause
#include "engine/structure/reversal.hpp"

#include "engine/structure/motion_units.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

StepDefect reversal_defect(const ObservedStep& at) {
    const TangentGroup& group = at.system.state_group();
    std::vector<Real> y(at.y, at.y + group.size()), inverse(y);
    StepDefect defect;
    Status status = at.step(at.t, at.h, y.data());
    if (status == Status::ok) status = at.step(at.t + at.h, -at.h, y.data());
    if (status != Status::ok) {
        defect.why_not = std::string("a step forth or back ends in ") + name(status);
        return defect;
    }
    group.inverse(at.y, inverse.data());
    group.multiply(inverse.data(), y.data(), y.data());
    VecX u(group.dim());
    group.log(y.data(), u.data());
    MotionUnits units(at.system, at.length);
    const Real rate = units.rate(at.t, at.h, at.y);
    defect.value = max(units(at.y, u.data()), Real(units(at.y, group.dv(u.data())) / rate));
    defect.uncertainty = 256 * epsilon * units.remoteness(at.y);
    return defect;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
