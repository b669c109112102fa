// SPDX-License-Identifier: BSD-3-Clause
#include "methods/rkmk/gauss.hpp"

#include "methods/implicit/stages/gauss_coefficients.hpp"
#include "methods/rkmk/implicit_rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Factory gauss(int stages) {
    return implicit_rkmk(
        stages, [stages] { return gauss_coefficients(stages); }, true);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
