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
#include <thread>

#include "records/json/diagnostics.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

using Clock = std::chrono::steady_clock;

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

    Answer answer_within(std::chrono::milliseconds patience) {
        Answer answer{.started = started_};
        if (!started_) { return answer; }
        const auto end = Clock::now() + patience;
        const auto status = read_until(end, answer.text) ? status_until(end) : std::nullopt;
        answer.in_time = status.has_value();
        if (status) {
            answer.code = WIFEXITED(*status) ? WEXITSTATUS(*status) : 128 + WTERMSIG(*status);
        } else {
            ::kill(child_, SIGKILL);
            while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {}
        }
        return answer;
    }

  private:
    // All that it writes; false if the end of it does not come in time.
    bool read_until(Clock::time_point end, std::string& text) const {
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

    // How it ended; nothing if it does not in time, for it may go on after its last word.
    std::optional<int> status_until(Clock::time_point end) const {
        int status = 0;
        while (::waitpid(child_, &status, WNOHANG) != child_) {
            if (Clock::now() > end) { return std::nullopt; }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return status;
    }

    Descriptor answer_;
    pid_t child_ = 0;
    bool started_ = false;
};

// A terminal may obey control characters.
std::string printable(std::string line) {
    std::erase_if(line, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
    return line;
}
std::string first_line(const std::string& text) { return printable(text.substr(0, text.find('\n'))); }
std::string last_line(const std::string& text) {
    const std::string trimmed = text.substr(0, text.find_last_not_of('\n') + 1);
    return printable(trimmed.substr(trimmed.rfind('\n') + 1));
}

Finding finding_of(const Tool& tool, std::chrono::milliseconds patience) {
    const std::string remedy = fmt::format("tools/setup {} ({})", tool.purpose, tool.use);
    const Answer answer = Asked(tool.question, false).answer_within(patience);
    if (!answer.started) { return {tool.topic, Health::missing, "not on the PATH", remedy}; }
    if (!answer.in_time) {
        return {tool.topic, Health::failed,
                fmt::format("no answer within {} s", std::chrono::duration<double>(patience).count()), remedy};
    }
    if (answer.code == 0 && !answer.text.empty()) { return {tool.topic, Health::well, first_line(answer.text), ""}; }
    const std::string said = last_line(Asked(tool.question, true).answer_within(patience).text);
    // Python without pandas is there, and lacks what is wanted.
    if (said.starts_with("ModuleNotFoundError")) { return {tool.topic, Health::missing, said, remedy}; }
    return {tool.topic, tool.in_error,
            fmt::format("exit code {}, and it said {}", answer.code, said.empty() ? "nothing" : in_quotes(said)),
            remedy};
}

}  // namespace

std::vector<Finding> find_tools(std::chrono::milliseconds patience) {
    std::vector<Finding> findings;
    for (const Tool& tool : all_tools()) { findings.push_back(finding_of(tool, patience)); }
    return findings;
}

}  // namespace kreisel
