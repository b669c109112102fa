// SPDX-License-Identifier: BSD-3-Clause
//
// Typed reading of a JSON value. Each function returns nothing if the value does not fit, after telling the
// diagnostics what was expected and what was found.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "records/json/diagnostics.hpp"

namespace kreisel {

/// Largest count a config may write.
inline constexpr long largest_count = 1'000'000'000;
/// Numbers are at most that large, and those that are greater than 0 at least that large: beyond, products of a few of
/// them leave the range of doubles.
inline constexpr double largest_number = 1e100, least_positive = 1e-100;

class Node {
  public:
    Node(const nlohmann::json& value, std::string pointer, Diagnostics& sink)
        : value_(&value), pointer_(std::move(pointer)), sink_(&sink) {}

    const nlohmann::json& json() const { return *value_; }
    const std::string& pointer() const { return pointer_; }
    Diagnostics& sink() const { return *sink_; }

    bool is_object() const { return value_->is_object(); }
    bool is_array() const { return value_->is_array(); }
    bool is_string() const { return value_->is_string(); }

    /// False, with an error, if this is not an object.
    bool require_object(const std::string& expected) const;
    /// Reports each key that is not among `known`, the keys `of` something.
    void only_keys(const std::vector<std::string>& known, const std::string& of = "") const;
    std::optional<Node> find(const std::string& key) const;
    /// As find; a missing key is an error.
    std::optional<Node> require(const std::string& key, const std::string& expected) const;

    /// The elements of a list that is not empty.
    std::optional<std::vector<Node>> elements(const std::string& expected) const;
    /// The same without those that equal an earlier one, which are errors, and nothing where there is no list: "each
    /// WHAT once". What is written differently and means the same is not found here.
    std::vector<Node> distinct_elements(const std::string& expected, const std::string& what) const;
    /// One element of a list.
    Node element(std::size_t index) const {
        return {(*value_)[index], pointer_below(pointer_, std::to_string(index)), *sink_};
    }
    /// The elements of a list, or the value itself.
    std::vector<Node> elements_or_self() const;

    /// At most `largest_number` in size.
    std::optional<double> number(const std::string& expected = "a number") const;
    /// At least `least_positive`.
    std::optional<double> positive(const std::string& expected = "a number greater than 0") const;
    /// A whole number in [least, most].
    std::optional<long> count(long least, long most, const std::string& what) const;
    std::optional<bool> flag() const;
    /// Text without control characters, at most `longest` characters.
    std::optional<std::string> text(const std::string& expected, std::size_t longest = 200) const;
    /// One of `names`, otherwise an error with the nearest one.
    std::optional<std::string> name(const std::string& what, const std::vector<std::string>& names) const;

    /// The value as a message shows it.
    std::string shown() const { return sink_->shown_value(pointer_, *value_); }
    void mismatch(const std::string& expected, const std::string& suggestion = "") const {
        sink_->mismatch(pointer_, *value_, expected, suggestion);
    }
    void error(const std::string& expected, const std::string& got, const std::string& suggestion = "") const {
        sink_->add({pointer_, expected, got, suggestion});
    }

    /// An error that no schema tells.
    void violates(Rule rule, const std::string& expected, const std::string& got) const {
        sink_->add({.pointer = pointer_, .expected = expected, .got = got, .rule = rule});
    }

    /// A remark that is not an error.
    void warn(const std::string& sentence) const { sink_->warn(pointer_, sentence); }

  private:
    const nlohmann::json* value_;
    std::string pointer_;
    Diagnostics* sink_;
};

/// The whole number that a value is, however it is written: 2, 2.0 or 2e0. Nothing if it is none or no double holds it.
std::optional<long> whole_number(const nlohmann::json& value);

/// Those that equal no earlier one as JSON. The others are errors: "each WHAT once".
std::vector<Node> distinct(const std::vector<Node>& nodes, const std::string& what);

/// True if `text` holds a control character (C0, DEL, C1) or a Unicode line separator.
bool has_control_character(std::string_view text);

}  // namespace kreisel
