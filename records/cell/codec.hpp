// SPDX-License-Identifier: BSD-3-Clause
//
// JSON of the types that a record holds. `decode` throws std::invalid_argument where a value does not fit; what is
// missing stays as it is.
#pragma once

#include <string>
#include <string_view>

#include "records/cell/record.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

std::string encoded(const std::string& text);
std::string encoded(long count);
std::string encoded(int count);
std::string encoded(double number);
std::string encoded(const JsonValue& value);
std::string encoded(const OptionValues& options);
std::string encoded(const std::optional<Order>& order);
std::string encoded(const std::map<std::string, std::string>& texts);
std::string encoded(const std::optional<LostIntegral>& lost);
std::string encoded(const std::optional<ReferenceNote>& reference);

/// Numbers of the engine: bare, or in quotes in quad.
std::string encoded(const std::optional<ReportedState>& state, bool quad);
std::string encoded(const ConstraintSummary& constraints, bool quad);
std::string encoded(const std::vector<std::pair<std::string, Number>>& metrics, bool quad);

void decode(const JsonValue& json, std::string& text);
void decode(const JsonValue& json, long& count);
void decode(const JsonValue& json, int& count);
void decode(const JsonValue& json, double& number);
void decode(const JsonValue& json, JsonValue& value);
void decode(const JsonValue& json, OptionValues& options);
void decode(const JsonValue& json, std::optional<Order>& order);
void decode(const JsonValue& json, std::map<std::string, std::string>& texts);
void decode(const JsonValue& json, std::optional<LostIntegral>& lost);
void decode(const JsonValue& json, std::optional<ReferenceNote>& reference);
void decode(const JsonValue& json, Number& number);
void decode(const JsonValue& json, ReportedState& state);
void decode(const JsonValue& json, std::optional<ReportedState>& state);
void decode(const JsonValue& json, ConstraintSummary& constraints);
void decode(const JsonValue& json, std::vector<std::pair<std::string, Number>>& metrics);

/// Whether the value is what a new record has.
bool is_default(const std::string& text);
bool is_default(long count);
bool is_default(int count);
bool is_default(double number);
bool is_default(const JsonValue& value);
bool is_default(const OptionValues& options);
bool is_default(const std::map<std::string, std::string>& texts);
bool is_default(const ConstraintSummary& constraints);
template <class Value>
bool is_default(const std::optional<Value>& value) {
    return !value;
}

void add_times(const CellTimes& times, ObjectWriter& object);
/// False where the member is not a time.
bool read_time(const JsonMember& member, CellTimes& times);
/// A cost as written, but for its times.
std::string without_times(std::string_view cost);

}  // namespace kreisel
