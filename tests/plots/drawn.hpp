// SPDX-License-Identifier: BSD-3-Clause
//
// Figures as a config asks for them, and their panels.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "plots/figures/kinds/panel_kind.hpp"
#include "plots/figures/spec.hpp"
#include "records/json/strict.hpp"

namespace kreisel::test {

inline std::unique_ptr<Figure> figure_read_from(const nlohmann::json& figure) {
    const Document document = parse_document("test.json", nlohmann::json{{"figure", figure}}.dump());
    Diagnostics diagnostics(document);
    auto figures = read_figures(Node(document.value["figure"], "/figure", diagnostics), "figure");
    diagnostics.raise();
    return std::move(figures.at(0));
}

inline PanelFigure panels_of(const nlohmann::json& figure, const Results& results) {
    return dynamic_cast<const PanelKind&>(*figure_read_from(figure)).panels(results);
}

}  // namespace kreisel::test
