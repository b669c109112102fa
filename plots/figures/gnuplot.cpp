// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "kreisel_build.hpp"
#include "records/provenance.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

// File actions of a child that is about to start.
class ChildSetup {
  public:
    ChildSetup(const std::filesystem::path& folder, const std::filesystem::path& messages) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, 1, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, 2, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    }
    ~ChildSetup() { posix_spawn_file_actions_destroy(&actions_); }
    ChildSetup(const ChildSetup&) = delete;
    ChildSetup& operator=(const ChildSetup&) = delete;

    int spawn(pid_t& child, std::vector<std::string> arguments) const {
        std::vector<char*> pointers;
        pointers.reserve(arguments.size() + 1);
        for (std::string& argument : arguments) { pointers.push_back(argument.data()); }
        pointers.push_back(nullptr);
        return posix_spawnp(&child, pointers[0], &actions_, nullptr, pointers.data(), environ);
    }

  private:
    posix_spawn_file_actions_t actions_{};
};

int wait_for(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) { throw FileError(fmt::format("gnuplot: {}", std::strerror(errno))); }
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::filesystem::path plot_scripts() {
    std::vector<std::filesystem::path> candidates;
    if (const char* chosen = std::getenv("KREISEL_PLOTS")) {
        candidates.emplace_back(chosen);
    } else {
        candidates.push_back(program_file().parent_path().parent_path() / "share" / "kreisel" / "plots");
        candidates.emplace_back(std::string(build::source_dir) + "/plots/gnuplot");
    }
    for (const auto& folder : candidates) {
        if (std::filesystem::exists(folder / "style.gp")) { return std::filesystem::absolute(folder); }
    }
    throw FileError(fmt::format("{}: no gnuplot scripts there (style.gp is missing); set KREISEL_PLOTS to their folder",
                                candidates.back().string()));
}

std::string run_gnuplot(const std::filesystem::path& folder, const std::filesystem::path& scripts,
                        const std::string& script, const std::string& name) {
    const auto log = std::filesystem::absolute(folder) / "plotdata" / (name + ".log");
    const std::string path = (scripts / (script + ".gp")).string();
    pid_t child = 0;
    const ChildSetup setup(folder, log);
    const int failure = setup.spawn(
        child, {"gnuplot", "-d", "-c", path, "plotdata/" + name + ".gp", "figures/" + name, scripts.string()});
    if (failure != 0) { throw FileError(fmt::format("gnuplot cannot be started: {}", std::strerror(failure))); }
    const int code = wait_for(child);
    std::string said = read_text(log);
    if (code != 0) { throw FileError(fmt::format("gnuplot failed with exit code {}: {}", code, said)); }
    if (said.empty()) { std::filesystem::remove(log); }
    return said;
}

}  // namespace kreisel
