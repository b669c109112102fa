// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/state_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string_view>

namespace kreisel {

namespace {

/// Names are made in one place: a table has a row of them for each cell.
class EntryVisitor {
  public:
    explicit EntryVisitor(const VisitStateEntry& visit) : visit_(visit) {}

    void add(std::string_view name, std::string_view family, std::string_view unit, const Number& number) {
        name_ = name;
        visit_({name_, family, unit}, number);
    }
    /// NAME.1, NAME.2, ...
    template <class Numbers>
    void add_all(std::string_view name, std::string_view family, std::string_view unit, const Numbers& numbers) {
        name_ = name;
        const std::size_t size = name_.size();
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            name_.resize(size);
            name_.append(".").append(std::to_string(i + 1));
            visit_({name_, family, unit}, numbers[i]);
        }
    }
    void add_body(const ReportedBody& body) {
        add_all(body.name + ".x", "x", "m", body.x);
        for (std::size_t row = 0; row < 3; ++row) {
            const std::string name = body.name + ".R." + std::to_string(row + 1);
            add_all(name, "R", "1", std::span(body.R).subspan(3 * row, 3));
        }
        add_all(body.name + ".v", "v", "m/s", body.v);
        add_all(body.name + ".omega", "omega", "rad/s", body.omega);
    }
    /// Names are "lambda.pin.2 [N]", or missing in lines of older versions.
    void add_multipliers(const ReportedState& state) {
        for (std::size_t i = 0; i < state.multipliers.size(); ++i) {
            const bool named = i < state.multiplier_names.size();
            const std::string title = named ? state.multiplier_names[i] : fmt::format("lambda.{}", i + 1);
            const auto end = std::min(title.rfind(" ["), title.size());
            const std::string unit = end == title.size() ? "" : title.substr(end + 2, title.size() - end - 3);
            add(title.substr(0, end), "multipliers" + title.substr(end), unit, state.multipliers[i]);
        }
    }
    void add_reaction(const ReportedReaction& reaction) {
        add_all("reaction." + reaction.joint + ".force", "reaction.force", "N", reaction.force);
        add_all("reaction." + reaction.joint + ".torque", "reaction.torque", "N m", reaction.torque);
        const std::string drive = "drive." + reaction.joint;
        if (reaction.driving_force) { add(drive + ".force", "drive.force", "N", *reaction.driving_force); }
        if (reaction.driving_torque) { add(drive + ".torque", "drive.torque", "N m", *reaction.driving_torque); }
    }

  private:
    const VisitStateEntry& visit_;
    std::string name_;
};

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

void for_each_state_entry(const ReportedState& state, const VisitStateEntry& visit) {
    EntryVisitor visitor(visit);
    visitor.add("t", "t", "s", state.t);
    for (const ReportedBody& body : state.bodies) { visitor.add_body(body); }
    visitor.add_multipliers(state);
    for (const ReportedReaction& reaction : state.reactions) { visitor.add_reaction(reaction); }
    visitor.add_all("theta", "theta", "rad", state.theta);
    for (std::size_t i = 0; i < state.turns.size(); ++i) {
        const Number turns{static_cast<double>(state.turns[i]), fmt::format("{}", state.turns[i])};
        visitor.add(fmt::format("turns.{}", i + 1), "turns", "1", turns);
    }
}

std::vector<StateEntry> state_entries(const ReportedState& state) {
    std::vector<StateEntry> all;
    for_each_state_entry(state, [&](const StateEntryName& entry, const Number& number) {
        all.push_back({std::string(entry.name), std::string(entry.family), std::string(entry.unit), number});
    });
    return all;
}

}  // namespace kreisel
