// SPDX-License-Identifier: BSD-3-Clause
//
// The JSON Schema of options that take texts (driver/config/reading/text_options.hpp).
#pragma once

#include "driver/config/schema/terms.hpp"
#include "methods/contract/description.hpp"

namespace kreisel::schema {

Schema text_option(OptionText text);

}  // namespace kreisel::schema
