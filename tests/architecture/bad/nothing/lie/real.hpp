// SPDX-License-Identifier: BSD-3-Clause
// Not 0.1 in a comment, not "0.1" in a string; [u, v] is a bracket and [known1900] a citation.
#pragma once
#include <cmath>
#include <Eigen/Core>
namespace kreisel {
inline namespace KREISEL_PRECISION {
using Real = double;
using std::sqrt;
inline const char* text = "0.1 std::sqrt(2.3) \" 0.7";
inline const char* raw = R"x(0.3 ")" 0.7)x";
inline const char quote = '"';
inline const Real dyadic[] = {0.5, 1.0, 0.375, 1e3, 2.5e-1, 6.25e-2, 1'000.5, .5};
inline const Real ratio = Real(1) / 10;
/* 0.1 */
}
}
