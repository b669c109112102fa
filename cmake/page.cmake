# Writes TO, a source with the style and the script of the report page: the files PARTS, those that end in .js in their
# order within one function, so that the program needs no file of them where it runs.
set(style "")
set(script "")
foreach(part IN LISTS PARTS)
  file(READ ${part} text)
  string(REGEX REPLACE "^[^\n]*SPDX[^\n]*\n" "" text "${text}")
  if(part MATCHES "[.]css$")
    string(APPEND style "${text}")
  else()
    string(APPEND script "${text}")
  endif()
endforeach()
file(WRITE ${TO} "// SPDX-License-Identifier: BSD-3-Clause
//
// Written by cmake/page.cmake.
namespace kreisel::build {

extern const char* const page_style;
extern const char* const page_script;
const char* const page_style = R\"page(${style})page\";
const char* const page_script = R\"page((() => {
'use strict';
${script}})();
)page\";

}  // namespace kreisel::build
")
