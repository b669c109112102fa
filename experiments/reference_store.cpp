// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/reference_store.hpp"

#include <fmt/format.h>

#include "experiments/files.hpp"
#include "experiments/hash.hpp"
#include "experiments/json_writer.hpp"

namespace kreisel {

namespace {

constexpr std::string_view sum_key = ",\"sum\":\"";

Number read_number(const nlohmann::json& json) {
    const auto& text = json.get_ref<const std::string&>();
    return {nlohmann::json::parse(text).get<double>(), text};
}

template <std::size_t n>
std::array<Number, n> read_numbers(const nlohmann::json& json) {
    std::array<Number, n> numbers;
    for (std::size_t i = 0; i < n; ++i) { numbers[i] = read_number(json.at(i)); }
    return numbers;
}

ReportedBody read_body(const nlohmann::json& json) {
    ReportedBody body;
    body.name = json.at("name");
    body.x = read_numbers<3>(json.at("x"));
    body.v = read_numbers<3>(json.at("v"));
    body.omega = read_numbers<3>(json.at("omega"));
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            body.R[3 * row + column] = read_number(json.at("R").at(row).at(column));
        }
    }
    return body;
}

Reference read_reference(const nlohmann::json& json) {
    Reference reference;
    const auto& state = json.at("state");
    reference.state.t = read_number(state.at("t"));
    for (const auto& body : state.at("bodies")) { reference.state.bodies.push_back(read_body(body)); }
    for (const auto& multiplier : state.value("multipliers", nlohmann::json::array())) {
        reference.state.multipliers.push_back(read_number(multiplier));
    }
    for (const auto& [name, error] : json.at("error").items()) { reference.error[name] = read_number(error); }
    reference.horizon = json.at("horizon");
    reference.route = json.at("route");
    return reference;
}

}  // namespace

std::filesystem::path reference_file(const std::filesystem::path& folder, const std::string& hash) {
    return folder / "references" / (hash + ".json");
}

std::optional<Reference> load_reference(const std::filesystem::path& file, const PlannedReference& planned,
                                        const std::string& build) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) { return std::nullopt; }
    const std::string text = read_text(file);
    const auto sum_at = text.rfind(sum_key);
    if (sum_at == std::string::npos ||
        text.substr(sum_at) !=
            fmt::format("{}{}\"}}\n", sum_key, hash_text(std::string_view(text).substr(0, sum_at)))) {
        return std::nullopt;
    }
    const auto json = nlohmann::json::parse(text);
    if (json.at("build") != build || json.at("of") != nlohmann::json::parse(planned.content)) { return std::nullopt; }
    return read_reference(json);
}

void store_reference(const std::filesystem::path& file, const PlannedReference& planned, const Reference& reference,
                     const std::string& build) {
    ObjectWriter error;
    for (const auto& [name, number] : reference.error) { error.member(name, json_value(number, true)); }
    ObjectWriter object;
    object.member("of", planned.content).member("build", json_text(build)).member("route", json_text(reference.route));
    object.member("horizon", json_number(reference.horizon)).member("error", error.text());
    const std::string text = object.member("state", json_value(reference.state, true)).open_text();
    write_atomically(file, fmt::format("{}{}{}\"}}\n", text, sum_key, hash_text(text)));
}

}  // namespace kreisel
