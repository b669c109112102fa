# Writes TO, a source with the commit of SOURCE, "-dirty" where files that git knows differ from it. Does not touch a
# file that is up to date.
function(ask_git variable)
  execute_process(COMMAND git ${ARGN} WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE
                  ERROR_QUIET RESULT_VARIABLE failed)
  if(failed)
    set(answer "unknown")
  endif()
  set(${variable} "${answer}" PARENT_SCOPE)
endfunction()

ask_git(commit rev-parse --short=12 HEAD)
ask_git(changes status --porcelain --untracked-files=no)
if(changes AND NOT changes STREQUAL "unknown")
  string(APPEND commit "-dirty")
endif()
file(CONFIGURE OUTPUT ${TO} @ONLY CONTENT [[// SPDX-License-Identifier: BSD-3-Clause
//
// Written by cmake/commit.cmake.
#include "kreisel_build.hpp"

const char* const kreisel::build::commit = "@commit@";
]])
