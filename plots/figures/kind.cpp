// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kind.hpp"

#include <algorithm>

namespace kreisel {

namespace {

std::vector<FigureKind>& registered_figures() {
    static std::vector<FigureKind> all;
    return all;
}

}  // namespace

FigureRegistration::FigureRegistration(std::function<std::unique_ptr<Figure>()> make, FigureKind kind) {
    kind.make = std::move(make);
    registered_figures().push_back(std::move(kind));
}

const std::vector<FigureKind>& figure_kinds() {
    static const std::vector<FigureKind> sorted = [] {
        auto all = registered_figures();
        std::sort(all.begin(), all.end(), [](const FigureKind& a, const FigureKind& b) { return a.name < b.name; });
        return all;
    }();
    return sorted;
}

const FigureKind* find_figure_kind(const std::string& name) {
    const auto& all = figure_kinds();
    const auto found = std::find_if(all.begin(), all.end(), [&](const FigureKind& kind) { return kind.name == name; });
    return found == all.end() ? nullptr : &*found;
}

const std::vector<FigureKey>& common_figure_keys() {
    static const std::vector<FigureKey> keys = {
        figure_key("name", &FigureSpec::name, figure_value::file_name(), "its files", "the experiment's name"),
        figure_key("title", &FigureSpec::title, figure_value::text("a title"), "text above the figure", "none"),
        figure_key("select", &FigureSpec::select, figure_value::selection(), "the cells to draw", "all")};
    return keys;
}

}  // namespace kreisel
