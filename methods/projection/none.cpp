// SPDX-License-Identifier: BSD-3-Clause
#include "methods/contract/projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_PROJECTION({.name = "none", .summary = "the step as it is: constraints drift", .cites = {}},
                   [](System&, const OptionValues&) { return std::make_unique<NoProjection>(); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
