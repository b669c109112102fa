// SPDX-License-Identifier: BSD-3-Clause
#include "methods/symmetric_projection/symmetric_projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(symmetric_projection("rkmk/gauss3"), symmetrically_projected("gauss3", "rkmk/gauss3", 6, "hairer2006"));

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
