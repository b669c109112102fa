// SPDX-License-Identifier: BSD-3-Clause
#include "plots/plot.hpp"

#include <fmt/format.h>

#include <iostream>
#include <memory>
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
void require_own_settings(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error) || read_text(file).starts_with(Settings().text())) { return; }
    throw FileError(
        fmt::format("{}: expected nothing at this name, or what kreisel plot has written, got another "
                    "file; please move it away",
                    file.string()));
}

// In a folder of results the files are derived ones, elsewhere files like any other.
void draw(Figure& figure, const Results& results, const PlotSettings& settings) {
    figure.note = what_is_wanting(results);
    if (!settings.output.empty()) { return write_and_draw(figure, results, settings.output); }
    const std::filesystem::path& folder = settings.folders.front();
    require_derived(folder, files_of(figure));
    require_own_settings(folder / "plotdata" / (figure.name + ".gp"));
    announce_files(folder, files_of(figure));
    try {
        write_and_draw(figure, results, folder);
    } catch (const FigureError&) {
        withdraw_files(folder, files_of(figure));
        throw;
    }
    record_sums(folder, files_of(figure));
}

using Locked = std::unique_ptr<FolderLock>;

// Each folder once.
std::vector<Locked> locked(const std::vector<std::filesystem::path>& folders) {
    std::vector<Locked> locks;
    std::set<std::filesystem::path> known;
    for (const std::filesystem::path& folder : folders) {
        require_results(folder);
        if (!known.insert(std::filesystem::canonical(folder)).second) {
            throw UsageError(fmt::format("plot: expected each folder once, got {} again", folder.string()));
        }
        locks.push_back(std::make_unique<FolderLock>(folder, ""));
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

Exit plot_command(const PlotSettings& settings, const PlannedIn& planned) {
    if (settings.folders.size() > 1 && settings.figure.empty()) {
        throw UsageError("plot: expected --figure FILE, which says what figures of several folders show; got none");
    }
    const std::vector<Locked> folders = locked(settings.folders);
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
