// SPDX-License-Identifier: BSD-3-Clause
#include "engine/structure/symplecticity.hpp"

#include "engine/structure/step_forms.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

StepDefect symplecticity_defect(const ObservedStep& at, const Real& sign) {
    const StepForms forms = step_forms(at, sign);
    StepDefect defect;
    defect.why_not = forms.why_not;
    if (!defect.why_not.empty()) return defect;
    defect.value = (forms.after - forms.before).norm() / forms.rate;
    defect.uncertainty = (forms.after - forms.coarse).norm() / forms.rate + forms.round_off;
    return defect;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
