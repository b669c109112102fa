// SPDX-License-Identifier: BSD-3-Clause
//
// A small results folder with a file of each sort.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/driver/command_line.hpp"

namespace kreisel {

/// Puts a text in place of what is in a file.
inline void put(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

/// Two cells with samples and a reference, in a folder that has all files of a format.
struct SmallFolder {
    ScratchFolder scratch;
    std::string config = scratch.file("small.json", R"({"name": "small", "kind": "convergence",
        "problems": ["heavy_top"], "methods": ["rkmk/rk4"], "time": {"end": 1, "steps": [2, 4]},
        "output": {"samples": 2}})");
    std::filesystem::path folder = scratch / "out";

    SmallFolder() {
        REQUIRE(run_program({"run", config, "-o", folder.string(), "-j", "1"}).code == 0);
        REQUIRE(run_program({"table", folder.string()}).code == 0);
    }
    /// A file of each sort.
    std::vector<std::filesystem::path> files() const {
        std::vector<std::filesystem::path> all;
        for (const char* name : {"results.jsonl", "journal.jsonl", "manifest.json", "results.csv", "sums.sha256"}) {
            all.push_back(folder / name);
        }
        all.push_back(folder / "geometry.json");
        for (const char* below : {"trajectories", "references"}) {
            all.push_back(std::filesystem::directory_iterator(folder / below)->path());
        }
        return all;
    }
};

}  // namespace kreisel
