// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/scaffold/new.hpp"

#include <fmt/ostream.h>

#include "driver/cli/scaffold/scaffold.hpp"
#include "kreisel_build.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

std::filesystem::path place_of(const Scaffold& scaffold, const std::filesystem::path& folder) {
    if (!folder.empty()) { return folder / scaffold.place.filename(); }
    if (!scaffold.place.has_parent_path()) { return scaffold.place; }
    const std::filesystem::path place = std::filesystem::path(build::source_dir) / scaffold.place;
    if (std::filesystem::is_directory(place.parent_path())) { return place; }
    throw UsageError(
        fmt::format("{}: there is no such folder, since the sources that kreisel was built from are not "
                    "here; give the folder with -o",
                    place.parent_path().string()));
}

std::string next_steps(const std::string& kind, const std::string& name, const std::filesystem::path& file) {
    if (kind == "method") {
        return fmt::format("change the coefficients, build kreisel, then: kreisel certify {}", name);
    }
    if (kind == "problem") { return fmt::format("change the model, build kreisel, then: kreisel info {}", name); }
    return fmt::format("change it, then: kreisel check {0} && kreisel run {0}", file.string());
}

}  // namespace

Exit new_command(const std::string& kind, const std::string& name, const std::filesystem::path& folder,
                 const Engines& engines, const Terminal& terminal) {
    const Scaffold scaffold = scaffold_of(kind, name, Catalogue(engines.binary64));
    const std::filesystem::path file = place_of(scaffold, folder);
    if (std::filesystem::exists(std::filesystem::symlink_status(file))) {
        throw FileError(fmt::format("{}: there is such a file; nothing is overwritten", file.string()));
    }
    if (!folder.empty()) { make_folder(folder); }
    write_atomically(file, scaffold.text);
    fmt::print(terminal.out, "{}\n", file.string());
    fmt::print(terminal.messages, "{}\n", next_steps(kind, name, file));
    return Exit::ok;
}

}  // namespace kreisel
