// SPDX-License-Identifier: BSD-3-Clause
//
// What must hold between the files of the project, rule by rule. Each rule returns its violations.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/architecture/source.hpp"

namespace architecture {

/// One violation: "path:line: rule: explanation" when printed.
struct Finding {
    std::string path;
    int line = 0;
    std::string rule;
    std::string explanation;
};

std::string to_string(const Finding& finding);

/// `arrow`: a room includes only what stands below it (rooms.cpp), files that exist, and the libraries it may know.
std::vector<Finding> check_includes(const std::vector<Source>& tree);

/// `room`: every source is in a room of the table or in a folder that sees everything; experiments/ holds none.
std::vector<Finding> check_rooms(const std::vector<Source>& tree);

/// `full`: no folder holds more sources than it may (capacity_of).
std::vector<Finding> check_capacities(const std::vector<Source>& tree);

/// `header`: a source has a header of its name, or registers what it holds (headers.cpp).
std::vector<Finding> check_headers(const std::vector<Source>& tree);

/// `licence`: an SPDX line among the first two lines of every source file and script; GPL-3.0-or-later where GSL is
/// included.
std::vector<Finding> check_licences(const std::vector<Source>& tree);

/// `literal`: no floating literal in numerical code except dyadic ones (0.5, 2.0, 1e3), which are the same number in
/// every precision. Exempt are statements whose literals become doubles by their type and are later read as decimals:
/// problem data (KREISEL_PROBLEM, ParameterDescription, BodyData, JointData, ForceData, Vector3, Matrix3),
/// `decimal(...)`, `moments(...)` and plain `double`.
std::vector<Finding> check_literals(const std::vector<Source>& tree);

/// `qualified`: no std::sqrt or similar in numerical code: for quad it would silently round to double.
std::vector<Finding> check_math_calls(const std::vector<Source>& tree);

/// `precision`: a file of numerical code that mentions Real puts it into the inline namespace of its precision.
std::vector<Finding> check_precision_namespace(const std::vector<Source>& tree);

/// `class`: no two files of the program define a class of one name in one namespace (class_names.cpp).
std::vector<Finding> check_class_names(const std::vector<Source>& tree);

/// `kind`: no file but those that register kinds of experiments, figures and tables names a kind, and none compares
/// with one (kinds.cpp).
std::vector<Finding> check_kinds(const std::vector<Source>& tree);

/// `cite`: every key in `.cites = {...}`, and every bracketed key (author and year) in a comment, is in the
/// bibliography.
std::vector<Finding> check_citations(const std::vector<Source>& tree, const std::set<std::string>& bibliography);

/// Keys of a BibTeX file. Throws std::runtime_error if a key occurs twice.
std::set<std::string> bibliography_keys(const std::string& bibtex);

/// Whether a decimal literal (digits, point, exponent, digit separators, no suffix) is k / 2^n with k < 2^53.
bool is_dyadic(const std::string& literal);

/// All rules.
std::vector<Finding> check_all(const std::vector<Source>& tree, const std::set<std::string>& bibliography);

}  // namespace architecture
