// SPDX-License-Identifier: BSD-3-Clause
//
// A long cell of the real program is stopped: its samples are on disk, identical to those of an uninterrupted run.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "driver/cli/cli.hpp"
#include "engine/engine.hpp"
#include "records/trajectory_file.hpp"

using namespace kreisel;

namespace {

std::string read(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// The lines of a sampled top whose step is 2^-20 s, over `end` seconds of its motion.
std::string config_text(double end) {
    std::ostringstream text;
    text << R"({"name": "long", "kind": "trajectory", "problems": ["heavy_top"], "methods": ["rkmk/rk4"], )"
            R"("metrics": [],)"
         << R"("time": {"end": )" << end << R"(, "steps": )" << static_cast<long>(end * 1048576)
         << R"(}, "output": {"samples": )" << static_cast<long>(end * 1024) << "}}";
    return text.str();
}

int run_program(const std::filesystem::path& config, const std::filesystem::path& out) {
    const std::string file = config.string(), folder = out.string();
    const char* const words[] = {"kreisel", "run", file.c_str(), "-o", folder.c_str(), "-j", "1"};
    return kreisel_main(7, words, engine_binary64(), engine_binary128());
}

}  // namespace

TEST_CASE("samples of a long cell are on disk before it is stopped or killed", "[campaign]") {
    std::string pattern = (std::filesystem::temp_directory_path() / "kreisel_samples_XXXXXX").string();
    const std::filesystem::path folder = ::mkdtemp(pattern.data());
    std::ofstream(folder / "short.json") << config_text(0.0625);
    std::ofstream(folder / "long.json") << config_text(512);
    REQUIRE(run_program(folder / "short.json", folder / "short") == 0);
    std::string whole;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "short" / "trajectories"))
        whole = read(entry.path());
    REQUIRE(std::count(whole.begin(), whole.end(), '\n') == 66);
    for (const int signal : {SIGTERM, SIGKILL}) {
        CAPTURE(signal);
        const auto out = folder / std::to_string(signal);
        const pid_t child = ::fork();
        if (child == 0) {
            if (std::freopen("/dev/null", "w", stderr) == nullptr) ::_exit(99);
            ::_exit(run_program(folder / "long.json", out));
        }
        std::string part;
        for (int i = 0; i < 3000 && part.size() <= whole.size(); ++i) {  // a minute at most
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            const auto parts = std::filesystem::exists(out / "trajectories") ? trajectory_parts(out)
                                                                             : std::vector<std::filesystem::path>();
            if (!parts.empty()) part = read(parts.front());
        }
        ::kill(child, signal);
        int status = 0;
        ::waitpid(child, &status, 0);
        CHECK((signal == SIGKILL ? WIFSIGNALED(status) : WIFEXITED(status) && WEXITSTATUS(status) == 130));
        const auto parts = trajectory_parts(out);
        REQUIRE(parts.size() == 1);
        part = read(parts.front());
        REQUIRE(part.size() > whole.size());
        CHECK(part.substr(0, whole.size()) == whole);
        CHECK(part.back() == '\n');
    }
    std::filesystem::remove_all(folder);
}
