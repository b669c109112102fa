// SPDX-License-Identifier: BSD-3-Clause
#include "lie/real.hpp"

#include <stdexcept>

namespace kreisel {
inline namespace KREISEL_PRECISION {

#if KREISEL_QUAD

std::string to_text(const Real& x) { return x.str(36, std::ios_base::scientific); }

Real from_text(const std::string& text) {
    try {
        return Real(text);
    } catch (const std::runtime_error&) { throw std::invalid_argument("not a decimal number: \"" + text + "\""); }
}

#else

std::string to_text(const Real& x) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

Real from_text(const std::string& text) {
    Real x = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
    if (error != std::errc() || end != text.data() + text.size())
        throw std::invalid_argument("not a decimal number: \"" + text + "\"");
    return x;
}

#endif

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
