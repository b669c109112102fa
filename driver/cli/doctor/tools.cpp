// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/doctor/tools.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <string>

#include "records/json/diagnostics.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds patience{10000};
constexpr std::size_t longest_answer = 4096;

struct Tool {
    std::string topic;
    std::vector<std::string> question;  ///< the command that prints its version
    std::string purpose;                ///< of tools/setup
    std::string use;
    Health in_error = Health::failed;  ///< what it means that it does not tell its version
};

const std::vector<Tool>& all_tools() {
    static const std::vector<Tool> tools = {
        {"gnuplot", {"gnuplot", "--version"}, "figures", "kreisel plot draws with it"},
        {"LaTeX", {"pdflatex", "--version"}, "paper", "the paper is typeset by it"},
        {"Slurm",
         {"sbatch", "--version"},
         "cluster",
         "kreisel slurm --submit needs it and a cluster, which tells its version",
         Health::poor},
        {"Chromium", {"chromium", "--version"}, "browser", "the tests of report pages"},
        {"Python, pandas",
         {"python3", "-c", "import sys, pandas; print(sys.version.split()[0] + ', ' + pandas.__version__)"},
         "python",
         "the Python package"},
        {"Valgrind", {"valgrind", "--version"}, "maintain", "counts of instructions"},
    };
    return tools;
}

struct Answer {
    bool started = false, in_time = true;
    int code = 0;
    std::string text;
};

/// A program that has been asked, with what it writes.
class Asked {
  public:
    /// `messages`: what it says of errors is part of its answer.
    Asked(std::vector<std::string> question, bool messages) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) { throw FileError(std::strerror(errno)); }
        answer_ = Descriptor(ends[0]);
        const Descriptor written(ends[1]);
        posix_spawn_file_actions_t actions{};
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, written.number(), 1);
        if (messages) {
            posix_spawn_file_actions_adddup2(&actions, written.number(), 2);
        } else {
            posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
        }
        std::vector<char*> pointers;
        for (std::string& word : question) { pointers.push_back(word.data()); }
        pointers.push_back(nullptr);
        started_ = ::posix_spawnp(&child_, pointers[0], &actions, nullptr, pointers.data(), environ) == 0;
        posix_spawn_file_actions_destroy(&actions);
    }

    Answer answer() {
        Answer answer{.started = started_};
        if (!started_) { return answer; }
        answer.in_time = read(answer.text);
        if (!answer.in_time) { ::kill(child_, SIGKILL); }
        int status = 0;
        while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {}
        answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        return answer;
    }

  private:
    // Up to its end; false if that does not come in time.
    bool read(std::string& text) const {
        const auto end = Clock::now() + patience;
        std::array<char, 512> part{};
        for (;;) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
            pollfd waiting{answer_.number(), POLLIN, 0};
            const int ready = left > 0 ? ::poll(&waiting, 1, static_cast<int>(left)) : 0;
            if (ready < 0 && errno == EINTR) { continue; }
            if (ready <= 0) { return false; }
            const ssize_t count = ::read(answer_.number(), part.data(), part.size());
            if (count <= 0) { return true; }
            if (text.size() < longest_answer) { text.append(part.data(), static_cast<std::size_t>(count)); }
        }
    }

    Descriptor answer_;
    pid_t child_ = 0;
    bool started_ = false;
};

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }
std::string last_line(const std::string& text) {
    const std::string trimmed = text.substr(0, text.find_last_not_of('\n') + 1);
    return trimmed.substr(trimmed.rfind('\n') + 1);
}

Finding finding_of(const Tool& tool) {
    const std::string remedy = fmt::format("tools/setup {} ({})", tool.purpose, tool.use);
    const Answer answer = Asked(tool.question, false).answer();
    if (!answer.started) { return {tool.topic, Health::missing, "not on the PATH", remedy}; }
    if (!answer.in_time) { return {tool.topic, Health::failed, "no answer within 10 s", remedy}; }
    if (answer.code == 0 && !answer.text.empty()) { return {tool.topic, Health::well, first_line(answer.text), ""}; }
    const std::string said = last_line(Asked(tool.question, true).answer().text);
    // Python without pandas is there, and lacks what is wanted.
    if (said.starts_with("ModuleNotFoundError")) { return {tool.topic, Health::missing, said, remedy}; }
    return {tool.topic, tool.in_error,
            fmt::format("exit code {}, and it said {}", answer.code, said.empty() ? "nothing" : in_quotes(said)),
            remedy};
}

}  // namespace

std::vector<Finding> find_tools() {
    std::vector<Finding> findings;
    for (const Tool& tool : all_tools()) { findings.push_back(finding_of(tool)); }
    return findings;
}

}  // namespace kreisel
