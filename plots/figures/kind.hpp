// SPDX-License-Identifier: BSD-3-Clause
//
// Kinds of figures: a file each in plots/figures/kinds/, which registers itself.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "plots/figures/figure.hpp"
#include "plots/figures/values.hpp"
#include "support/registration.hpp"

namespace kreisel {

/// A key of a figure. Reader, JSON Schema and `kreisel info` follow from it.
struct FigureKey {
    std::string name;
    std::string values;  ///< what it may be, in words
    std::string meaning;
    std::string absent;  ///< what is drawn without it, where it has no default value: "all"
    std::function<nlohmann::ordered_json()> schema;
    std::function<void(const Node&, Figure&)> read;
    std::function<nlohmann::ordered_json(const Figure&)> value;  ///< null: none; of a new figure it is the default
};

/// Null for what is empty or absent.
template <class T>
nlohmann::ordered_json json_of(const T& value) {
    if constexpr (requires { value.empty(); }) {
        if (value.empty()) { return nullptr; }
    }
    return value;
}
template <class T>
nlohmann::ordered_json json_of(const std::optional<T>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// The key `name` of figures of a type, kept in one of its members.
template <class Type, class Member, class Value>
FigureKey figure_key(std::string name, Member Type::*member, figure_value::Type<Value> type, std::string meaning,
                     std::string absent = "") {
    return {std::move(name),
            type.words,
            std::move(meaning),
            std::move(absent),
            type.schema,
            [=](const Node& node, Figure& figure) {
                if (auto value = type.read(node)) { static_cast<Type&>(figure).*member = std::move(*value); }
            },
            [=](const Figure& figure) { return json_of(static_cast<const Type&>(figure).*member); }};
}

/// What a figure draws, and therefore needs of an experiment.
enum class FigureData { final_states, samples, timed_cells };

struct FigureKind {
    std::string name;
    std::string summary;
    FigureData draws = FigureData::final_states;
    std::string script;                     ///< plots/gnuplot/SCRIPT.gp draws it
    std::vector<FigureKey> keys;            ///< besides those of all kinds
    std::vector<std::string> metrics = {};  ///< what it can draw, where that is not measured on problems
    std::string otherwise = {};  ///< the kind that stands for it by default where no cell has its metrics; empty: none
    std::function<std::unique_ptr<Figure>()> make = {};
};

/// All of them, by name.
const std::vector<FigureKind>& figure_kinds();
/// Null where there is none of that name.
const FigureKind* find_figure_kind(const std::string& name);
/// The keys that figures of all kinds have, besides "kind": name, title, select.
const std::vector<FigureKey>& common_figure_keys();

/// Records a kind; a static object of this type is what KREISEL_FIGURE declares.
struct FigureRegistration {
    FigureRegistration(std::function<std::unique_ptr<Figure>()> make, FigureKind kind);
};

}  // namespace kreisel

/// KREISEL_FIGURE(Type derived from Figure, {.name = "drift", .summary = "...", .draws = ..., .script = "lines",
///                                            .keys = {...}}).
#define KREISEL_FIGURE(Type, ...) \
    KREISEL_REGISTER(             \
        ::kreisel::FigureRegistration, [] { return std::make_unique<Type>(); }, __VA_ARGS__)
