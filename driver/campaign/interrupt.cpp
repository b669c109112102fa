// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/interrupt.hpp"

#include <atomic>
#include <ctime>

namespace kreisel {

namespace {

constexpr long patience = 2000;  // ms

std::atomic<long> interrupted = 0;  // when, in ms; 0: not
static_assert(std::atomic<long>::is_always_lock_free, "a handler may use no other");

int guards = 0;  // that live

long milliseconds() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return 1 + 1000 * now.tv_sec + now.tv_nsec / 1000000;
}

extern "C" void note_interrupt(int signal) {
    const long now = milliseconds();
    if (interrupted == 0) { interrupted = now; }
    if (now - interrupted < patience) { return; }
    std::signal(signal, SIG_DFL);  // NOLINT(cppcoreguidelines-pro-type-cstyle-cast): the system's macro
    std::raise(signal);
}

void on_signal(int signal, void (*handler)(int), struct sigaction& old) {
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, &old);
}

}  // namespace

InterruptGuard::InterruptGuard() {
    if (guards++ == 0) { interrupted = 0; }
    on_signal(SIGINT, note_interrupt, old_interrupt_);
    on_signal(SIGTERM, note_interrupt, old_terminate_);
    on_signal(SIGPIPE, SIG_IGN, old_pipe_);  // NOLINT(cppcoreguidelines-pro-type-cstyle-cast): the system's macro
    on_signal(SIGXFSZ, SIG_IGN, old_size_);  // NOLINT(cppcoreguidelines-pro-type-cstyle-cast)
}

InterruptGuard::~InterruptGuard() {
    --guards;
    if (requested()) { return; }
    ::sigaction(SIGINT, &old_interrupt_, nullptr);
    ::sigaction(SIGTERM, &old_terminate_, nullptr);
    ::sigaction(SIGPIPE, &old_pipe_, nullptr);
    ::sigaction(SIGXFSZ, &old_size_, nullptr);
}

bool InterruptGuard::requested() { return interrupted != 0; }

}  // namespace kreisel
