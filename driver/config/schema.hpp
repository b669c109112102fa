// SPDX-License-Identifier: BSD-3-Clause
//
// The shape of a config as a JSON Schema, made from the same registries the reader uses.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "driver/config/catalogue.hpp"

namespace kreisel {

/// Draft-07. What depends on several places at once (samples that divide steps, labels of their own, steps that divide
/// the end time, figures with different names), and physical validity are beyond it: only there the reader is stricter.
nlohmann::ordered_json config_schema(const Catalogue& catalogue);

}  // namespace kreisel
