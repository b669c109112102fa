// SPDX-License-Identifier: BSD-3-Clause
#include "lie/real.hpp"
const Vector3 omega = {0, 150, -4.61538};
namespace kreisel {
inline namespace KREISEL_PRECISION {
const Real spin = decimal(-4.61538);
}
}
KREISEL_PROBLEM(top, {.name = "top", .parameters = table(15, {0.2, 1, -0.3})});
