# Writes TO, a source with the texts of the files FROM by their names without ending: what `kreisel new` starts from.
set(entries "")
foreach(file IN LISTS FROM)
  get_filename_component(name ${file} NAME_WLE)
  file(READ ${file} text)
  string(APPEND entries "        {\"${name}\", R\"scaffold(${text})scaffold\"},\n")
endforeach()
file(WRITE ${TO} "// SPDX-License-Identifier: BSD-3-Clause
//
// Written by cmake/scaffolds.cmake.
#include \"driver/cli/scaffold/texts.hpp\"

namespace kreisel {

const std::map<std::string, std::string>& scaffold_texts() {
    static const std::map<std::string, std::string> texts = {
${entries}    };
    return texts;
}

}  // namespace kreisel
")
