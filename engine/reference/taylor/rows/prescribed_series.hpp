// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "engine/reference/taylor/power_series.hpp"
#include "mechanics/model/prescribed.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// f(t + s) of a prescribed coordinate as a series in s.
void expand(const Prescribed& law, const Real& t, Scalars& series);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
