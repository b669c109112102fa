// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the whole program inside a test, and manages its files.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "driver/config/catalogue.hpp"
#include "tests/driver/fake_engine.hpp"

namespace kreisel {

/// One engine for tests that only read descriptions and run cells.
inline const FakeEngine plain_engine;
inline const Engines one_engine{plain_engine, plain_engine};

struct ProgramResult {
    int code = 0;
    std::string out, messages;
};

/// Runs kreisel_main with the fake engine for both precisions; `words` without the program's name.
ProgramResult run_program(const std::vector<std::string>& words, const Engine& engine);
ProgramResult run_program(const std::vector<std::string>& words);

/// The same of a program without quad precision.
ProgramResult run_program_in_double(const std::vector<std::string>& words, const Engine& engine);

/// A folder that is empty at first and is removed when the test ends.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    /// Writes a file and returns its path.
    std::string file(const std::string& name, const std::string& text) const;

  private:
    std::filesystem::path path_;
};

std::string contents(const std::filesystem::path& file);

/// JSON of one line with a sum of its own, whether it has one already or not.
std::string summed_line(const std::string& line);
/// Writes a manifest with a sum of its own.
void write_summed(const std::filesystem::path& manifest, nlohmann::ordered_json json);

/// A good config of 12 cells: two methods, one of them in two charts, two projections, two step counts.
std::string good_config();

}  // namespace kreisel
