// SPDX-License-Identifier: BSD-3-Clause
//
// `kreisel list` and `kreisel info` on kinds of experiments, kinds of figures and tables, which know no engine.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace kreisel {

/// kinds, figures, tables.
const std::vector<std::string>& kind_topics();
/// Prints one of them, or all if `topic` is empty.
void list_kinds(const std::string& topic, std::ostream& out);

/// All their names.
std::vector<std::string> names_of_kinds();
/// Prints all about what has this name: a kind of experiments may share it with a kind of figures and a table. False
/// where nothing has it.
bool describe_kind(const std::string& name, std::ostream& out);

}  // namespace kreisel
