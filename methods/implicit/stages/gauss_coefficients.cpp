// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/stages/gauss_coefficients.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

StageCoefficients two_gauss_stages() {
    const Real quarter = Real(1) / 4, r = sqrt(Real(3)) / 6;
    StageCoefficients made{MatX(2, 2), {}, VecX(2), VecX(2)};
    made.a << quarter, quarter - r, quarter + r, quarter;
    made.a_hat = made.a;
    made.b << Real(1) / 2, Real(1) / 2;
    made.c << Real(1) / 2 - r, Real(1) / 2 + r;
    return made;
}

StageCoefficients three_gauss_stages() {
    const Real outer = Real(5) / 36, inner = Real(2) / 9, r = sqrt(Real(15));
    StageCoefficients made{MatX(3, 3), {}, VecX(3), VecX(3)};
    made.a << outer, inner - r / 15, outer - r / 30,  //
        outer + r / 24, inner, outer - r / 24,        //
        outer + r / 30, inner + r / 15, outer;
    made.a_hat = made.a;
    made.b << 2 * outer, 2 * inner, 2 * outer;
    made.c << Real(1) / 2 - r / 10, Real(1) / 2, Real(1) / 2 + r / 10;
    return made;
}

}  // namespace

StageCoefficients gauss_coefficients(int stages) { return stages == 2 ? two_gauss_stages() : three_gauss_stages(); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
