// SPDX-License-Identifier: BSD-3-Clause
#include "plots/plot.hpp"

#include <fmt/format.h>

#include <iostream>

#include "plots/figures/gnuplot.hpp"
#include "plots/figures/kind.hpp"
#include "plots/figures/spec.hpp"
#include "plots/wanting.hpp"
#include "records/folder/derived_files.hpp"
#include "records/sums/sum_list.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

// The files of a figure, below the folder.
std::vector<std::string> files_of(const Figure& figure) {
    std::vector<std::string> files;
    for (const char* ending : {".pdf", ".svg", ".png"}) { files.push_back("figures/" + figure.name + ending); }
    return files;
}

void draw(Figure& figure, const Results& results, const std::filesystem::path& folder,
          const std::filesystem::path& scripts) {
    figure.note = what_is_wanting(results);
    require_derived(folder, files_of(figure));
    figure.write(results, folder);
    announce_files(folder, files_of(figure));
    const std::string said = run_gnuplot(folder, scripts, find_figure_kind(figure.kind)->script, figure.name);
    if (!said.empty()) { std::cerr << "gnuplot on " << figure.name << ": " << said << "\n"; }
    record_sums(folder, files_of(figure));
    fmt::print("{}\n", (folder / "figures" / (figure.name + ".{pdf,svg,png}")).string());
}

// False, with a message, if what it does cannot be drawn.
template <class Draw>
bool is_drawn(const Draw& draw_it) {
    try {
        draw_it();
        return true;
    } catch (const FigureError& error) {
        std::cerr << "not drawn: " << error.what() << "\n";
        return false;
    }
}

}  // namespace

Exit plot_command(const std::filesystem::path& folder, const PlannedCells& planned) {
    require_results(folder);
    const FolderLock lock(folder, "");
    const Results results = read_results(folder, planned);
    print_wanting(results);
    std::vector<std::unique_ptr<Figure>> figures;
    bool drawn = is_drawn([&] { figures = figures_of(results); });
    const auto scripts = plot_scripts();
    make_folder(folder / "figures");
    for (const auto& figure : figures) {
        drawn = is_drawn([&] { draw(*figure, results, folder, scripts); }) && drawn;
    }
    if (!results.damage.empty()) { return Exit::io; }
    return drawn ? Exit::ok : Exit::cells_failed;
}

}  // namespace kreisel
