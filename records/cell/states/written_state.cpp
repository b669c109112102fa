// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/states/written_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "records/json/written/written.hpp"

namespace kreisel {

namespace {

/// Without the quotes of quad; what is missing is 0.
std::string_view number_of(std::string_view json) {
    if (json.empty()) { return "0"; }
    return json.starts_with('"') ? json.substr(1, json.size() - 2) : json;
}

template <std::size_t n>
std::array<std::string_view, n> numbers_in(WrittenObject& object, const char* name) {
    std::array<std::string_view, n> numbers;
    numbers.fill(number_of(""));
    const std::string_view json = object.value_of(name);
    if (json.empty()) { return numbers; }
    const auto all = scalars_of(json);
    if (all.size() != n) { throw std::invalid_argument(fmt::format("{}: expected {} numbers", name, n)); }
    std::transform(all.begin(), all.end(), numbers.begin(), number_of);
    return numbers;
}

/// The elements of a list that may be missing, each as `take` takes it.
template <class Take>
auto list_in(WrittenObject& object, const char* name, const Take& take) {
    std::vector<decltype(take(std::string_view()))> list;
    const std::string_view json = object.value_of(name);
    if (json.empty()) { return list; }
    for (const std::string_view element : elements_of(json)) { list.push_back(take(element)); }
    return list;
}

WrittenBody written_body(std::string_view json, std::size_t place) {
    WrittenObject object(json);
    const std::string_view name = object.value_of("name");
    WrittenBody body{name.empty() ? fmt::format("body{}", place) : text_of(name), {}, {}, {}, {}};
    body.x = numbers_in<3>(object, "x");
    body.R = numbers_in<9>(object, "R");
    body.v = numbers_in<3>(object, "v");
    body.omega = numbers_in<3>(object, "omega");
    return body;
}

WrittenReaction written_reaction(std::string_view json) {
    WrittenObject object(json);
    const auto drive = [&](const char* name) {
        const std::string_view number = object.value_of(name);
        return number.empty() ? std::nullopt : std::optional(number_of(number));
    };
    WrittenReaction reaction{text_of(object.value_of("joint")), {}, {}, {}, {}};
    reaction.force = numbers_in<3>(object, "force");
    reaction.torque = numbers_in<3>(object, "torque");
    reaction.driving_force = drive("driving_force");
    reaction.driving_torque = drive("driving_torque");
    return reaction;
}

}  // namespace

WrittenState written_state(std::string_view json) {
    WrittenObject object(json);
    WrittenState state;
    state.t = number_of(object.value_of("t"));
    std::size_t place = 0;
    state.bodies = list_in(object, "bodies", [&](std::string_view body) { return written_body(body, ++place); });
    state.multipliers = list_in(object, "multipliers", number_of);
    state.multiplier_names = list_in(object, "multiplier_names", [](std::string_view name) { return text_of(name); });
    state.reactions = list_in(object, "reactions", written_reaction);
    state.theta = list_in(object, "theta", number_of);
    state.turns = list_in(object, "turns", number_of);
    return state;
}

}  // namespace kreisel
