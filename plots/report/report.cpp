// SPDX-License-Identifier: BSD-3-Clause
#include "plots/report/report.hpp"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "plots/report/figures.hpp"
#include "plots/report/motion.hpp"
#include "plots/report/page.hpp"
#include "plots/report/tables.hpp"
#include "plots/wanting.hpp"
#include "records/folder/derived_files.hpp"
#include "records/json/writer.hpp"
#include "records/manifest.hpp"
#include "records/reading/read_results.hpp"
#include "records/remarks/lost_integrals.hpp"
#include "records/remarks/past_horizon.hpp"
#include "records/sums/sum_list.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

const std::string report_file = "report.html";

// The manifest without what is shown elsewhere; null where there is none that can be read.
std::string provenance_json(const std::filesystem::path& folder) {
    try {
        auto manifest = read_summed_manifest(manifest_file(folder, "")).value;
        for (const char* known : {"config", "files", "sum", "units", "cells", "journal"}) { manifest.erase(known); }
        return manifest.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    } catch (const FileError&) { return "null"; }  // none, or damaged: that is said with the other damage
}

// What results say about themselves.
std::vector<std::string> remarks_on(const Results& results) {
    std::vector<std::string> remarks = past_horizon_notes(results.rows);
    for (std::string& note : lost_integral_notes(results.rows)) { remarks.push_back(std::move(note)); }
    return remarks;
}

std::string data_json(const Results& results, const std::filesystem::path& folder, const std::string& figures) {
    std::vector<std::string> damage = results.damage;
    if (!results.warning.empty()) { damage.push_back(results.warning); }
    const std::string tables = report_tables(results);
    const std::size_t room = room_for_motion(figures.size() + tables.size());
    return ObjectWriter()
        .member("name", json_text(results.name))
        .member("kind", json_text(results.kind))
        .member("wanting", json_text(what_is_wanting(results)))
        .member("damage", json_value(damage))
        .member("remarks", json_value(remarks_on(results)))
        .member("config", results.config.empty() ? "null" : results.config)
        .member("provenance", provenance_json(folder))
        .member("figures", figures)
        .member("motions", report_motion(results, folder, room))
        .member("tables", tables)
        .text();
}

// The page of the folder is a derived file of it also where it is given as the output.
bool is_page_of(const std::filesystem::path& folder, const std::filesystem::path& output) {
    std::error_code error;
    const auto parent = output.has_parent_path() ? output.parent_path() : std::filesystem::path(".");
    return output.empty() || (output.filename() == report_file && std::filesystem::equivalent(parent, folder, error));
}

// That the page can be written, before it is made.
void require_place(const std::filesystem::path& folder, const std::filesystem::path& output) {
    if (!output.empty()) { return require_own({output}, output, report_page_mark()); }
    const std::string why = why_not_writable(folder);
    if (why.empty()) { return; }
    throw FileError(fmt::format("{}: cannot be written: {}; -o FILE writes the page elsewhere",
                                (folder / report_file).string(), why));
}

// In the folder it is one of its derived files, elsewhere a file like any other.
void write_page(const std::string& page, const std::filesystem::path& folder, const std::filesystem::path& output) {
    if (!output.empty()) { return write_atomically(output, page); }
    require_derived(folder, {report_file});
    announce_files(folder, {report_file});
    write_atomically(folder / report_file, page);
    record_sums(folder, {report_file});
}

}  // namespace

Exit report_command(const std::filesystem::path& folder, const std::filesystem::path& wanted,
                    const PlannedCells& planned) {
    require_results(folder);
    const std::filesystem::path output = is_page_of(folder, wanted) ? std::filesystem::path() : wanted;
    require_place(folder, output);
    const FolderLock lock = output.empty() ? FolderLock(folder, "") : FolderLock::of_reader(folder);
    const Results results = read_results(folder, planned);
    print_wanting(results);
    const ReportFigures figures = report_figures(results);
    for (const std::string& why : figures.not_drawn) { std::cerr << "not drawn: " << why << "\n"; }
    const std::string page = report_page(results.name + " — kreisel", data_json(results, folder, figures.json));
    write_page(page, folder, output);
    fmt::print("{}\n", (output.empty() ? folder / report_file : output).string());
    if (!results.damage.empty()) { return Exit::io; }
    return figures.not_drawn.empty() ? Exit::ok : Exit::cells_failed;
}

}  // namespace kreisel
