// SPDX-License-Identifier: BSD-3-Clause
//
// The names of the numbers of a state, whether these are Numbers or texts. Internal to state entries and tables.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace kreisel {

/// A name as StateEntry has it, for the moment of a visit.
struct StateEntryName {
    std::string_view name, family, unit;
};

/// Names are made in one place: a table has a row of them for each cell.
template <class Visit>
class StateNamer {
  public:
    explicit StateNamer(const Visit& visit) : visit_(visit) {}

    template <class Number>
    void add(std::string_view name, std::string_view family, std::string_view unit, const Number& number) {
        name_ = name;
        visit_(StateEntryName{name_, family, unit}, number);
    }
    /// NAME.1, NAME.2, ...
    template <class Numbers>
    void add_all(std::string_view name, std::string_view family, std::string_view unit, const Numbers& numbers) {
        name_ = name;
        add_indexed(family, unit, numbers);
    }
    template <class Body>
    void add_body(const Body& body) {
        add_quantity(body.name, "x", "m", body.x);
        for (std::size_t row = 0; row < 3; ++row) {
            name_.assign(body.name).append(".R.").append(std::to_string(row + 1));
            add_indexed("R", "1", std::span(body.R).subspan(3 * row, 3));
        }
        add_quantity(body.name, "v", "m/s", body.v);
        add_quantity(body.name, "omega", "rad/s", body.omega);
    }
    /// Names are "lambda.pin.2 [N]", or missing in lines of older versions.
    template <class State>
    void add_multipliers(const State& state) {
        for (std::size_t i = 0; i < state.multipliers.size(); ++i) {
            const bool named = i < state.multiplier_names.size();
            const std::string title = named ? state.multiplier_names[i] : "lambda." + std::to_string(i + 1);
            const auto end = std::min(title.rfind(" ["), title.size());
            const std::string unit = end == title.size() ? "" : title.substr(end + 2, title.size() - end - 3);
            add(title.substr(0, end), "multipliers" + title.substr(end), unit, state.multipliers[i]);
        }
    }
    template <class Reaction>
    void add_reaction(const Reaction& reaction) {
        add_all("reaction." + reaction.joint + ".force", "reaction.force", "N", reaction.force);
        add_all("reaction." + reaction.joint + ".torque", "reaction.torque", "N m", reaction.torque);
        const std::string drive = "drive." + reaction.joint;
        if (reaction.driving_force) { add(drive + ".force", "drive.force", "N", *reaction.driving_force); }
        if (reaction.driving_torque) { add(drive + ".torque", "drive.torque", "N m", *reaction.driving_torque); }
    }

  private:
    /// "rod.x" of "rod".
    template <class Numbers>
    void add_quantity(std::string_view owner, std::string_view quantity, std::string_view unit,
                      const Numbers& numbers) {
        name_.assign(owner).append(".").append(quantity);
        add_indexed(quantity, unit, numbers);
    }
    template <class Numbers>
    void add_indexed(std::string_view family, std::string_view unit, const Numbers& numbers) {
        name_ += '.';
        const std::size_t size = name_.size();
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            name_.resize(size);
            name_ += std::to_string(i + 1);
            visit_(StateEntryName{name_, family, unit}, numbers[i]);
        }
    }

    const Visit& visit_;
    std::string name_;
};

/// Visits t, x.1 ... omega.3 of each body, R row by row, multipliers ("lambda.pin.2"), reactions
/// ("reaction.pin.force.1"), what keeps prescribed coordinates ("drive.pin.torque"), angles and turns of torsion
/// springs ("theta.1"). State: ReportedState, or what has its members with other numbers; `turns` as these.
template <class State, class Turns, class Visit>
void name_state(const State& state, const Turns& turns, const Visit& visit) {
    StateNamer namer(visit);
    namer.add("t", "t", "s", state.t);
    for (const auto& body : state.bodies) { namer.add_body(body); }
    namer.add_multipliers(state);
    for (const auto& reaction : state.reactions) { namer.add_reaction(reaction); }
    namer.add_all("theta", "theta", "rad", state.theta);
    namer.add_all("turns", "turns", "1", turns);
}

}  // namespace kreisel
