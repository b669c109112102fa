// SPDX-License-Identifier: BSD-3-Clause
#include "engine/structure/volume.hpp"

#include "engine/structure/step_forms.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// |det S|, by elimination with row pivoting.
Real absolute_determinant(MatX S) {
    Real product = 1;
    for (Eigen::Index k = 0; k < S.cols(); ++k) {
        Eigen::Index pivot = 0;
        product *= S.col(k).tail(S.rows() - k).cwiseAbs().maxCoeff(&pivot);
        if (!(product > 0)) return product;
        S.row(k).swap(S.row(k + pivot));
        for (Eigen::Index i = k + 1; i < S.rows(); ++i) {
            const Real factor = S(i, k) / S(k, k);
            S.row(i).tail(S.cols() - k) -= factor * S.row(k).tail(S.cols() - k);
        }
    }
    return product;
}

}  // namespace

StepDefect volume_defect(const ObservedStep& at) {
    const StepForms forms = step_forms(at);
    StepDefect defect;
    defect.why_not = forms.why_not;
    if (!defect.why_not.empty()) return defect;
    const Real before = absolute_determinant(forms.before / forms.rate);
    const Real fine = sqrt(absolute_determinant(forms.after / forms.rate) / before);
    const Real coarse = sqrt(absolute_determinant(forms.coarse / forms.rate) / before);
    defect.value = abs(fine - 1);
    defect.uncertainty = abs(fine - coarse) + forms.round_off * sqrt(Real(forms.before.cols()));
    return defect;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
