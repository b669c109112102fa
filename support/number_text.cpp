// SPDX-License-Identifier: BSD-3-Clause
#include "support/number_text.hpp"

#include <fmt/compile.h>

namespace kreisel {

std::string exact_text(double value) { return fmt::format(FMT_COMPILE("{}"), value); }

std::string rounded_text(double value, int digits) { return fmt::format("{:.{}e}", value, digits); }

}  // namespace kreisel
