// SPDX-License-Identifier: BSD-3-Clause
#include "plots/plot.hpp"

#include <fmt/format.h>

#include <iostream>

#include "plots/figures/gnuplot.hpp"
#include "plots/figures/kinds/bodies.hpp"
#include "records/json/strict.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

std::vector<FigureSpec> figures_of(const Results& results) {
    if (results.config.empty()) { throw FileError("manifest.json: no config in it; figures need one"); }
    const Document document = parse_document("manifest.json (config)", results.config);
    if (!document.value.contains("figure")) {
        return {standard_figure(results.kind.empty() ? "trajectory" : results.kind, results.name)};
    }
    Diagnostics diagnostics(document);
    const auto specs = read_figures(Node(document.value.at("figure"), "/figure", diagnostics), results.name);
    diagnostics.raise();
    return specs;
}

void write_data(const FigureSpec& spec, const Results& results, const std::filesystem::path& folder) {
    const auto plotdata = folder / "plotdata";
    if (spec.kind == "path3d" || spec.kind == "motion") { return write_bodies(plotdata, spec, results, folder); }
    if (spec.kind == "convergence") { return write_panels(plotdata, convergence_figure(spec, results)); }
    if (spec.kind == "drift") { return write_panels(plotdata, drift_figure(spec, results, folder)); }
    if (spec.kind == "invariants") { return write_panels(plotdata, invariants_figure(spec, results, folder)); }
    if (spec.kind == "scaling") { return write_panels(plotdata, scaling_figure(spec, results)); }
    if (spec.kind == "components") { return write_panels(plotdata, components_figure(spec, results, folder)); }
    throw FigureError(fmt::format("{}: no figure shows an experiment of kind {}; describe one under \"figure\"",
                                  spec.name, spec.kind));
}

bool draw(const FigureSpec& spec, const Results& results, const std::filesystem::path& folder,
          const std::filesystem::path& scripts) {
    try {
        write_data(spec, results, folder);
    } catch (const FigureError& error) {
        std::cerr << "not drawn: " << error.what() << "\n";
        return false;
    }
    const std::string said = run_gnuplot(folder, scripts, spec.kind, spec.name);
    if (!said.empty()) { std::cerr << "gnuplot on " << spec.name << ": " << said << "\n"; }
    fmt::print("{}\n", (folder / "figures" / (spec.name + ".{pdf,svg,png}")).string());
    return true;
}

}  // namespace

Exit plot_command(const std::filesystem::path& folder) {
    const Results results = read_results(folder);
    for (const std::string& damage : results.damage) { std::cerr << damage << "\n"; }
    const auto specs = figures_of(results);
    const auto scripts = plot_scripts();
    make_folder(folder / "figures");
    bool drawn = true;
    for (const FigureSpec& spec : specs) { drawn = draw(spec, results, folder, scripts) && drawn; }
    if (!results.damage.empty()) { return Exit::io; }
    return drawn ? Exit::ok : Exit::cells_failed;
}

}  // namespace kreisel
