// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kind.hpp"

#include "support/registered.hpp"

namespace kreisel {

FigureRegistration::FigureRegistration(std::function<std::unique_ptr<Figure>()> make, FigureKind kind) {
    kind.make = std::move(make);
    Registered<FigureKind>::add(std::move(kind));
}

const std::vector<FigureKind>& figure_kinds() { return Registered<FigureKind>::all(); }

const FigureKind* find_figure_kind(const std::string& name) { return Registered<FigureKind>::find(name); }

const std::vector<FigureKey>& common_figure_keys() {
    static const std::vector<FigureKey> keys = {
        figure_key("name", &FigureSpec::name, figure_value::file_name(), "its files", "the experiment's name"),
        figure_key("title", &FigureSpec::title, figure_value::text("a title"), "text above the figure", "none"),
        figure_key("select", &FigureSpec::select, figure_value::selection(), "the cells to draw", "all")};
    return keys;
}

}  // namespace kreisel
