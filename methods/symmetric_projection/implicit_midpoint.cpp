// SPDX-License-Identifier: BSD-3-Clause
#include "methods/symmetric_projection/symmetric_projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(symmetric_projection("rkmk/implicit_midpoint"),
               symmetrically_projected("implicit_midpoint", "rkmk/implicit_midpoint", 2, "hairer2006"));

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
