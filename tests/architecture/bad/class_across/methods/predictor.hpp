// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct Predictor {
    Real value;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
