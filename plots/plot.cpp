// SPDX-License-Identifier: BSD-3-Clause
#include "plots/plot.hpp"

#include <fmt/format.h>

#include <iostream>
#include <set>

#include "plots/figures/cells/joined.hpp"
#include "plots/figures/gnuplot.hpp"
#include "plots/figures/kind.hpp"
#include "plots/figures/settings.hpp"
#include "plots/figures/spec.hpp"
#include "plots/wanting.hpp"
#include "records/folder/derived_files.hpp"
#include "records/reading/read_results.hpp"
#include "records/sums/sum_list.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

// The files of a figure, below the folder.
std::vector<std::string> files_of(const Figure& figure) {
    std::vector<std::string> files;
    for (const char* ending : {".pdf", ".svg", ".png"}) { files.push_back("figures/" + figure.name + ending); }
    return files;
}

void write_and_draw(const Figure& figure, const Results& results, const std::filesystem::path& output) {
    figure.write(results, output);
    const std::string said = run_gnuplot(output, plot_scripts(), find_figure_kind(figure.kind)->script, figure.name);
    if (!said.empty()) { std::cerr << "gnuplot on " << figure.name << ": " << said << "\n"; }
    fmt::print("{}\n", (output / "figures" / (figure.name + ".{pdf,svg,png}")).string());
}

// What gnuplot reads is not listed: its first line tells whose it is.
std::filesystem::path gnuplot_file(const std::filesystem::path& folder, const Figure& figure) {
    return folder / "plotdata" / (figure.name + ".gp");
}

// Where no list of sums tells whose the files of a figure are, what gnuplot has read for them does.
void require_own_figure(const std::filesystem::path& folder, const Figure& figure) {
    const auto gp = gnuplot_file(folder, figure);
    std::vector<std::filesystem::path> files = {gp};
    for (const std::string& file : files_of(figure)) { files.push_back(folder / file); }
    require_own(files, gp, Settings().text());
}

// In a folder of results the files are derived ones, elsewhere files like any other.
void draw(Figure& figure, const Results& results, const PlotSettings& settings) {
    figure.note = what_is_wanting(results);
    if (!settings.output.empty()) {
        require_own_figure(settings.output, figure);
        return write_and_draw(figure, results, settings.output);
    }
    const std::filesystem::path& folder = settings.folders.front();
    require_derived(folder, files_of(figure));
    const auto gp = gnuplot_file(folder, figure);
    require_own({gp}, gp, Settings().text());
    announce_files(folder, files_of(figure));
    try {
        write_and_draw(figure, results, folder);
    } catch (const FigureError&) {
        withdraw_files(folder, files_of(figure));
        throw;
    }
    record_sums(folder, files_of(figure));
}

// Where the folder of the results is the one to draw into, figures are derived files of it, as without an output.
PlotSettings with_place(PlotSettings settings) {
    std::error_code error;
    if (std::filesystem::equivalent(settings.output, settings.folders.front(), error)) { settings.output.clear(); }
    return settings;
}

// That figures can be written, before they are drawn.
void require_writable(const PlotSettings& settings) {
    if (!settings.output.empty()) { return; }
    const std::filesystem::path& folder = settings.folders.front();
    const std::string why = why_not_writable(folder);
    if (why.empty()) { return; }
    throw FileError(
        fmt::format("{}: cannot be written: {}; -o FOLDER draws elsewhere", (folder / "figures").string(), why));
}

// Each folder once. The first is written to unless figures go elsewhere.
std::vector<FolderLock> locked(const PlotSettings& settings) {
    std::vector<FolderLock> locks;
    std::set<std::filesystem::path> known;
    for (const std::filesystem::path& folder : settings.folders) {
        if (!known.insert(std::filesystem::canonical(folder)).second) {
            throw UsageError(fmt::format("plot: expected each folder once, got {} again", folder.string()));
        }
        const bool writes = settings.output.empty() && locks.empty();
        locks.push_back(writes ? FolderLock(folder, "") : FolderLock::of_reader(folder));
    }
    return locks;
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

Exit plot_command(const PlotSettings& wanted, const PlannedIn& planned) {
    const PlotSettings settings = with_place(wanted);
    if (settings.folders.size() > 1 && settings.figure.empty()) {
        throw UsageError("plot: expected --figure FILE, which says what figures of several folders show; got none");
    }
    for (const std::filesystem::path& folder : settings.folders) { require_results(folder); }
    require_writable(settings);
    const std::vector<FolderLock> folders = locked(settings);
    std::vector<Results> all;
    for (const std::filesystem::path& folder : settings.folders) {
        all.push_back(read_results(folder, planned ? PlannedCells([&] { return planned(folder); }) : PlannedCells()));
        print_wanting(all.back());
    }
    const Results results = joined(std::move(all));
    std::vector<std::unique_ptr<Figure>> figures;
    bool drawn = is_drawn([&] {
        figures = settings.figure.empty() ? figures_of(results)
                                          : figures_in_file(settings.figure, settings.figure.stem().string());
    });
    make_folder((settings.output.empty() ? settings.folders.front() : settings.output) / "figures");
    for (const auto& figure : figures) {
        drawn = is_drawn([&] { draw(*figure, results, settings); }) && drawn;
    }
    if (!results.damage.empty()) { return Exit::io; }
    return drawn ? Exit::ok : Exit::cells_failed;
}

}  // namespace kreisel
