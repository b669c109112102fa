// SPDX-License-Identifier: BSD-3-Clause
//
// Lagrange's top: symmetric about the axis that carries the fixed point and the mass centre, in constant gravity: three
// integrals, and a closed form by elliptic functions [goldstein2002, Sec. 5.7] (problems/lagrange_top_closed_form.hpp).
// m = 1 kg, J = diag(0.2, 0.2, 0.3) kg m^2 about the mass centre, lever (0, 0, 0.5) m, inclined by acos 0.8: it
// nutates. The numbers are our own choice.
#include "problems/top.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::vector<ParameterDescription> inclined() {
    auto parameters = top_parameters(1, diagonal(0.2, 0.2, 0.3), {0, 0, 0.5}, {0.5, 0, 15});
    parameters.back().standard = Matrix3{1, 0, 0, 0, 0.8, -0.6, 0, 0.6, 0.8};
    return parameters;
}

}  // namespace

KREISEL_PROBLEM(top, {.name = "lagrange_top",
                      .summary = "the symmetric heavy top of Lagrange, nutating: integrable",
                      .cites = {"goldstein2002"},
                      .parameters = inclined()});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
