// SPDX-License-Identifier: BSD-3-Clause
//
// States over time.
#include "records/kinds/kind.hpp"

namespace kreisel {

namespace {

Advice advise_samples(const ExperimentRequest& request) {
    if (request.samples > 0) { return {}; }
    return {"a trajectory without \"output\": {\"samples\": ...} keeps its final state only"};
}

}  // namespace

KREISEL_EXPERIMENT({.name = "trajectory",
                    .summary = "states over time",
                    .metrics = {"defect.*", "invariant.*"},
                    .figure = "components",
                    .advise = advise_samples});

}  // namespace kreisel
