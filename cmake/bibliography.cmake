# Writes TO, a source with the text of the bibliography FROM, so that the program needs no file of it where it runs.
file(READ ${FROM} bibliography)
file(WRITE ${TO} "// SPDX-License-Identifier: BSD-3-Clause
//
// Written by cmake/bibliography.cmake.
namespace kreisel::build {

extern const char* const bibliography;
const char* const bibliography = R\"bibtex(${bibliography})bibtex\";

}  // namespace kreisel::build
")
