// SPDX-License-Identifier: BSD-3-Clause
#include "engine/metrics/comparison.hpp"

#include <limits>

#include "engine/metrics/metric.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

MultiplierDistance Separation::unknown_multipliers() {
    const Real unknown = std::numeric_limits<Real>::quiet_NaN();
    return {unknown, unknown};
}

std::map<std::string, Number> errors_of(const Separation& apart, const std::vector<ConstraintRow>& rows) {
    std::map<std::string, Number> errors;
    for (const Metric& metric : metrics()) {
        if (!metric.of_separation || !occurs(metric.description.rows, rows)) continue;
        if (const Real error = metric.of_separation(apart); isfinite(error))
            errors[metric.description.name] = to_number(error);
    }
    return errors;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
