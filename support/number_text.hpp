// SPDX-License-Identifier: BSD-3-Clause
//
// A number as text, by purpose: all digits, for messages, for tables. The numerical code uses `brief_text` only; the
// digits of its own numbers come from to_text (lie/real.hpp).
#pragma once

#include <cstdio>
#include <string>

namespace kreisel {

/// At most ten digits, for messages.
inline std::string brief_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

/// The shortest decimal that reads back as the value.
std::string exact_text(double value);

/// A size in scientific notation with so many digits after the point: "1.2e-10".
std::string rounded_text(double value, int digits);

}  // namespace kreisel
