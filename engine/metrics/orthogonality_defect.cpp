// SPDX-License-Identifier: BSD-3-Clause
#include "engine/metrics/metric.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METRIC({.name = "defect.orthogonality",
                .unit = "1",
                .symbol = "max |R^T R − I|",
                .summary = "largest Frobenius norm of R^T R - I over all steps",
                .scale = MetricScale::one,
                .place = 7},
               [](Observation& now) { return Real(now.system().group().orthogonality_defect(now.y())); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
