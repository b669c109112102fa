// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "records/json/lists.hpp"
#include "records/json/model.hpp"
#include "support/number_text.hpp"

namespace kreisel {

namespace {

template <class Values>
std::string json_map(const Values& values) {
    ObjectWriter object;
    for (const auto& [name, value] : values) { object.member(name, json_value(value)); }
    return object.text();
}

/// The characters that are neither escaped nor checked: most texts are names.
constexpr auto plain_characters = [] {
    std::array<bool, 256> plain{};
    for (unsigned char c = ' '; c <= '~'; ++c) { plain[c] = c != '"' && c != '\\'; }
    return plain;
}();

bool is_plain(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](unsigned char c) { return plain_characters[c]; });
}

void append_number(std::string& json, const Number& number, bool quad) {
    if (!std::isfinite(number.value)) { throw std::logic_error("the engine reported a number that is not finite"); }
    if (quad) { json += '"'; }
    json += number.text;
    if (quad) { json += '"'; }
}

void append_text(std::string& json, std::string_view text) {
    if (!is_plain(text)) {
        json += nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
        return;
    }
    json += '"';
    json += text;
    json += '"';
}

}  // namespace

std::string json_text(std::string_view text) {
    std::string quoted;
    append_text(quoted, text);
    return quoted;
}

ObjectWriter& ObjectWriter::member(std::string_view key, std::string_view json) {
    value(key) += json;
    return *this;
}

std::string& ObjectWriter::value(std::string_view key) {
    if (text_.size() > 1) { text_ += ','; }
    append_text(text_, key);
    text_ += ':';
    return text_;
}

std::string json_number(double value) {
    if (!std::isfinite(value)) { throw std::logic_error("a number to be written is not finite"); }
    return exact_text(value);
}

std::string json_value(const OptionValue& value) {
    return std::visit(
        [](const auto& held) -> std::string {
            using Held = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<Held, std::string>) {
                return json_text(held);
            } else if constexpr (std::is_same_v<Held, double>) {
                return json_number(held);
            } else {
                return fmt::format("{}", held);
            }
        },
        value);
}

std::string json_value(const ParameterValue& value) {
    return std::visit(
        [](const auto& held) -> std::string {
            using Held = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<Held, double>) {
                return json_number(held);
            } else if constexpr (std::is_same_v<Held, bool>) {
                return held ? "true" : "false";
            } else if constexpr (std::is_same_v<Held, Vector3>) {
                return json_list(held, json_number);
            } else if constexpr (std::is_same_v<Held, Matrix3>) {
                return json_rows(held, json_number);
            } else {
                return json_list(held, [](const auto& entry) { return json_element(entry); });
            }
        },
        value);
}

std::string json_value(const OptionValues& values) { return json_map(values); }

std::string json_value(const ParameterValues& values) { return json_map(values); }

std::string json_value(const std::vector<std::string>& texts) { return json_list(texts, json_text); }

std::string json_value(const Number& number, bool quad) {
    std::string json;
    append_number(json, number, quad);
    return json;
}

std::string json_value(const ReportedState& state, bool quad) {
    const auto write = [quad](const Number& number) { return json_value(number, quad); };
    const auto append = [quad](std::string& json, const Number& number) { append_number(json, number, quad); };
    const auto write_body = [&](const ReportedBody& body) {
        ObjectWriter object;
        append_text(object.value("name"), body.name);
        append_list(object.value("x"), body.x, append);
        append_rows(object.value("R"), body.R, append);
        append_list(object.value("v"), body.v, append);
        append_list(object.value("omega"), body.omega, append);
        return object.text();
    };
    ObjectWriter object;
    object.member("t", write(state.t)).member("bodies", json_list(state.bodies, write_body));
    if (!state.multipliers.empty()) { append_list(object.value("multipliers"), state.multipliers, append); }
    if (!state.multiplier_names.empty()) { object.member("multiplier_names", json_value(state.multiplier_names)); }
    const auto write_reaction = [&](const ReportedReaction& reaction) {
        ObjectWriter one;
        append_text(one.value("joint"), reaction.joint);
        append_list(one.value("force"), reaction.force, append);
        append_list(one.value("torque"), reaction.torque, append);
        if (reaction.driving_force) { one.member("driving_force", write(*reaction.driving_force)); }
        if (reaction.driving_torque) { one.member("driving_torque", write(*reaction.driving_torque)); }
        return one.member("unique", reaction.unique ? "true" : "false").text();
    };
    if (!state.reactions.empty()) { object.member("reactions", json_list(state.reactions, write_reaction)); }
    if (!state.turns.empty()) {
        append_list(object.value("theta"), state.theta, append);
        object.member("turns", json_list(state.turns, [](long turns) { return std::to_string(turns); }));
    }
    return object.text();
}

}  // namespace kreisel
