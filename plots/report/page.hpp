// SPDX-License-Identifier: BSD-3-Clause
//
// The report as one HTML file that loads nothing: style, script and data stand in it.
#pragma once

#include <string>

namespace kreisel {

/// Makes JSON safe within an HTML element: no "<" is left.
std::string json_within_html(const std::string& json);
/// Text within HTML.
std::string html_escaped(const std::string& text);

/// How every page begins.
std::string report_page_mark();

/// The page. Its policy (Content-Security-Policy) allows this one script, by its SHA-256, inline styles, and images and
/// files that the script makes; nothing is ever requested.
std::string report_page(const std::string& title, const std::string& data);

}  // namespace kreisel
