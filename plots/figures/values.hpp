// SPDX-License-Identifier: BSD-3-Clause
//
// Types of the values that a key of a figure may have. Each knows how it is read, its JSON Schema, and how it is said
// in words.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "records/json/node.hpp"

namespace kreisel::figure_value {

template <class T>
struct Type {
    std::string words;                               ///< "a whole number from 1 to 4"
    std::function<nlohmann::ordered_json()> schema;  ///< made when all metrics are registered
    /// Nothing, with a message to the node's diagnostics, for a value of another type.
    std::function<std::optional<T>(const Node&)> read;
};

using Names = std::vector<std::string>;
using Selection = std::map<std::string, Names>;

Type<std::string> text(const std::string& expected);
/// A file name without extension.
Type<std::string> file_name();
/// One of `names`; `what` says of what.
Type<std::string> choice(const std::string& what, const Names& names);
/// An axis of the experiment: problem, formulation, method, projection or precision.
Type<std::string> axis();
Type<bool> flag();
Type<long> count(long least, long most, const std::string& what);
Type<double> positive(const std::string& expected);
Type<double> number(const std::string& expected);
/// A number in [least, most].
Type<double> between(double least, double most, const std::string& what);
/// Of a figure, in mm: a number, or "column" or "page" for those of a journal.
Type<double> page_width();
/// Two numbers, the first one smaller.
Type<std::array<double, 2>> range();
/// A list of exactly n numbers.
template <std::size_t n>
Type<std::array<double, n>> numbers(const std::string& expected);
extern template Type<std::array<double, 2>> numbers(const std::string& expected);
extern template Type<std::array<double, 3>> numbers(const std::string& expected);
/// A metric, or a list of them: those of the engine and first integrals whose names begin with one of `families`, such
/// as "error.", and those that are the `own` ones of the figure.
Type<Names> metrics(const Names& families, const Names& own = {});
/// A list of different texts that is not empty.
Type<Names> names(const std::string& expected);
/// Texts by names.
Type<std::map<std::string, std::string>> texts(const std::string& expected);
/// Values, one or a list, by axis, "steps", "tolerance", "parameter.NAME", "option.NAME", "projection_option.NAME".
Type<Selection> selection();

}  // namespace kreisel::figure_value

namespace kreisel {

/// True for a name that is safe as a file name everywhere: 1 to 80 of a-z, 0-9, "_", "-", not "-" in front.
bool is_figure_name(const std::string& name);

}  // namespace kreisel
