// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/state_entries.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "records/cell/states/state_names.hpp"

namespace kreisel {

namespace {

/// "rod", "R", {2, 3} of "rod.R.2.3": a name, a quantity and one or two indices, counted from 0.
struct EntryName {
    std::string owner, quantity;
    std::vector<std::size_t> indices;

    explicit EntryName(std::string name) {
        for (std::size_t dot = name.rfind('.'); dot != std::string::npos; dot = name.rfind('.')) {
            const std::string last = name.substr(dot + 1);
            if (last.size() != 1 || last < "1" || last > "9") { break; }
            indices.insert(indices.begin(), static_cast<std::size_t>(last[0] - '1'));
            name.resize(dot);
        }
        const std::size_t dot = name.rfind('.');
        quantity = dot == std::string::npos ? name : name.substr(dot + 1);
        owner = dot == std::string::npos ? "" : name.substr(0, dot);
    }
};

template <class Owner>
Owner& owner_named(std::vector<Owner>& all, std::string Owner::*name, const std::string& wanted) {
    for (Owner& one : all) {
        if (one.*name == wanted) { return one; }
    }
    Owner& added = all.emplace_back();
    added.*name = wanted;
    return added;
}

template <std::size_t n>
bool put_component(std::array<Number, n>& numbers, std::size_t index, const Number& number) {
    if (index < n) { numbers[index] = number; }
    return index < n;
}

bool put_into_body(ReportedBody& body, const EntryName& name, const Number& number) {
    const auto& at = name.indices;
    if (name.quantity == "R") { return at.size() == 2 && put_component(body.R, 3 * at[0] + at[1], number); }
    auto& numbers = name.quantity == "x" ? body.x : name.quantity == "v" ? body.v : body.omega;
    return at.size() == 1 && put_component(numbers, at[0], number);
}

bool put_into_state(ReportedState& state, const StateEntry& entry) {
    constexpr std::string_view reaction = "reaction.", drive = "drive.";
    const EntryName name(entry.name);
    const std::string& what = name.quantity;
    if (entry.name == "t") { return state.t = entry.number, true; }
    if (entry.name.starts_with("theta.")) { return state.theta.push_back(entry.number), true; }
    if (entry.name.starts_with("turns.")) { return state.turns.push_back(std::lround(entry.number.value)), true; }
    if (entry.name.starts_with("lambda.") && (entry.unit == "N" || entry.unit == "N m" || entry.unit.empty())) {
        if (!entry.unit.empty()) { state.multiplier_names.push_back(entry.name + " [" + entry.unit + "]"); }
        return state.multipliers.push_back(entry.number), true;
    }
    if (entry.name.starts_with(reaction) && (what == "force" || what == "torque") && name.indices.size() == 1) {
        auto& joint = owner_named(state.reactions, &ReportedReaction::joint, name.owner.substr(reaction.size()));
        return put_component(what == "force" ? joint.force : joint.torque, name.indices[0], entry.number);
    }
    if (entry.name.starts_with(drive) && (what == "force" || what == "torque") && name.indices.empty()) {
        auto& joint = owner_named(state.reactions, &ReportedReaction::joint, name.owner.substr(drive.size()));
        return (what == "force" ? joint.driving_force : joint.driving_torque) = entry.number, true;
    }
    const bool of_body = what == "x" || what == "R" || what == "v" || what == "omega";
    return of_body && put_into_body(owner_named(state.bodies, &ReportedBody::name, name.owner), name, entry.number);
}

}  // namespace

ReportedState state_of(const std::vector<StateEntry>& entries) {
    ReportedState state;
    for (const StateEntry& entry : entries) {
        if (!put_into_state(state, entry)) {
            throw std::invalid_argument(fmt::format("\"{}\" is not a number of a state", entry.name));
        }
    }
    return state;
}

std::vector<StateEntry> state_entries(const ReportedState& state) {
    std::vector<Number> turns;
    for (const long count : state.turns) { turns.push_back({static_cast<double>(count), std::to_string(count)}); }
    std::vector<StateEntry> all;
    name_state(state, turns, [&](const StateEntryName& entry, const Number& number) {
        all.push_back({std::string(entry.name), std::string(entry.family), std::string(entry.unit), number});
    });
    return all;
}

}  // namespace kreisel
