// SPDX-License-Identifier: BSD-3-Clause
#include "methods/symmetric_projection/symmetric_projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(symmetric_projection("rkmk/gauss2"), symmetrically_projected("gauss2", "rkmk/gauss2", 4, "hairer2006"));

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
