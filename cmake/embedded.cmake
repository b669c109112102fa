# Writes TO, a source with the text of FROM, but for what stands above its first empty line, as kreisel::build::NAME.
file(READ ${FROM} text)
string(FIND "${text}" "\n\n" header)
math(EXPR body "${header} + 1")
string(SUBSTRING "${text}" ${body} -1 text)
file(WRITE ${TO} "// SPDX-License-Identifier: BSD-3-Clause
//
// Written by cmake/embedded.cmake.
namespace kreisel::build {

extern const char* const ${NAME};
const char* const ${NAME} = R\"text(${text})text\";

}  // namespace kreisel::build
")
