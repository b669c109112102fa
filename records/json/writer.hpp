// SPDX-License-Identifier: BSD-3-Clause
//
// JSON as text whose bytes depend on the values alone: keys in a fixed order, numbers as their shortest decimals.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/engine.hpp"

namespace kreisel {

std::string json_text(std::string_view text);  ///< quoted and escaped
std::string json_number(double value);         ///< the shortest decimal that reads back; throws on NaN and infinity
std::string json_value(const OptionValue& value);
std::string json_value(const ParameterValue& value);
std::string json_value(const OptionValues& values);
std::string json_value(const ParameterValues& values);
std::string json_value(const std::vector<std::string>& texts);

/// An engine's number: bare for double, in quotes for quad, whose digits a JSON reader would round.
/// Throws std::logic_error if it is not finite.
std::string json_value(const Number& number, bool quad);
std::string json_value(const ReportedState& state, bool quad);

/// "{" member "," member "}".
class ObjectWriter {
  public:
    ObjectWriter& member(std::string_view key, std::string_view json);
    /// Begins a member; its value is to be added to the text.
    std::string& value(std::string_view key);
    std::string text() const { return text_ + "}"; }
    /// Without the closing brace.
    const std::string& open_text() const { return text_; }

  private:
    std::string text_ = "{";
};

}  // namespace kreisel
