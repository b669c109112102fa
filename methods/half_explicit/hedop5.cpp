// SPDX-License-Identifier: BSD-3-Clause
//
// HEDOP5: the method of order 5 of Dormand and Prince as a half-explicit one, with an explicit first stage and an
// eighth row, c_8 = 19/20, where velocities are constrained to find the multipliers of the seventh stage, which lies
// where the step ends [arnoldmurua1998].
#include "methods/half_explicit/half_explicit.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const HalfExplicitScheme hedop5{
    .a = {{{1, 5}},
          {{3, 40}, {9, 40}},
          {{44, 45}, {-56, 15}, {32, 9}},
          {{19372, 6561}, {-25360, 2187}, {64448, 6561}, {-212, 729}},
          {{9017, 3168}, {-355, 33}, {46732, 5247}, {49, 176}, {-5103, 18656}},
          {{35, 384}, 0, {500, 1113}, {125, 192}, {-2187, 6784}, {11, 84}},
          {{-18611506045861, 19738176307200},
           {59332529, 14479296},
           {-2509441598627, 893904224850},
           {2763523204159, 3289696051200},
           {-41262869588913, 116235927142400},
           {46310205821, 287848404480},
           {-3280, 75413}}},
    .result = 7,
    .d = {0, 0, 0, 0, 0, 0, 1},
};

KREISEL_METHOD(
    half_explicit(hedop5),
    {.name = "half_explicit/hedop5",
     .order = {5, 5, 4},
     .cites = {"arnoldmurua1998", "braseyhairer1993", "dormand1980", "munthekaas1998"},
     .summary = "half-explicit Runge-Kutta method HEDOP5 of order 5 for velocity constraints, after Dormand and Prince",
     .variable_cost = true,
     .form = Form::half_explicit,
     .reports_multipliers = true,
     .meets_velocities = true,
     .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
