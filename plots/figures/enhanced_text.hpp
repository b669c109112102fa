// SPDX-License-Identifier: BSD-3-Clause
//
// Text for gnuplot. Labels are its enhanced text, in which some characters are mark-up.
#pragma once

#include <cstddef>
#include <string>

namespace kreisel {

/// `text`, enhanced text or a plain name, as a single-quoted string of gnuplot. Throws std::invalid_argument on a
/// control character.
std::string gnuplot_quoted(const std::string& text);
/// Makes enhanced text show `text` as it is.
std::string enhanced_escape(const std::string& text);
/// Width of enhanced text in characters: mark-up does not count.
std::size_t enhanced_width(const std::string& text);

}  // namespace kreisel
