// SPDX-License-Identifier: BSD-3-Clause
//
// The program in a process of its own, which tests can starve, interrupt and kill.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "driver/cli/cli.hpp"
#include "engine/engine.hpp"

namespace kreisel {

class ProgramProcess {
  public:
    /// `prepare` is called in the new process, and decides what its messages are written to.
    ProgramProcess(const std::vector<std::string>& words, const Engine& engine, const std::function<void()>& prepare)
        : process_((std::fflush(nullptr), ::fork())) {  // what is pending would be printed by both
        if (process_ != 0) { return; }
        prepare();
        std::vector<const char*> arguments = {"kreisel"};
        for (const std::string& word : words) { arguments.push_back(word.c_str()); }
        ::_exit(kreisel_main(static_cast<int>(arguments.size()), arguments.data(), engine, engine));
    }
    ~ProgramProcess() {
        if (process_ > 0) { signal(SIGKILL), wait(); }
    }
    ProgramProcess(const ProgramProcess&) = delete;
    ProgramProcess& operator=(const ProgramProcess&) = delete;

    void signal(int number) const { ::kill(process_, number); }
    /// Its exit code, or minus the signal that ended it.
    int wait() {
        int status = 0;
        ::waitpid(process_, &status, 0);
        process_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }

  private:
    pid_t process_;
};

inline void pause_for(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// Waits for a condition, at most ten seconds.
inline bool comes_true(const std::function<bool()>& condition) {
    for (int i = 0; i < 1000 && !condition(); ++i) { pause_for(0.01); }
    return condition();
}

inline void say_nothing() { ::close(STDERR_FILENO); }

}  // namespace kreisel
