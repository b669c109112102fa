// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/workers/worker_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

#include "driver/campaign/workers/limits.hpp"
#include "driver/campaign/workers/parent.hpp"

#ifdef KREISEL_COVERAGE
extern "C" void __gcov_dump();  // NOLINT(bugprone-reserved-identifier): the compiler's
#endif

namespace kreisel {

namespace {

std::stop_source* stop_of_worker = nullptr;

// Where nothing waits for a stop_source, request_stop only changes an atomic number, which a handler may do.
extern "C" void stop_worker(int) { stop_of_worker->request_stop(); }

void on_signal(int signal, void (*handler)(int)) {
    struct sigaction action = {};
    action.sa_handler = handler;  // without SA_RESTART: waiting for a lock ends
    ::sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
}

// The program may catch what a worker has to die of.
void catch_nothing() {
    for (int signal = 1; signal < NSIG; ++signal) {
        on_signal(signal, SIG_DFL);  // NOLINT(cppcoreguidelines-pro-type-cstyle-cast): the system's macro
    }
}

void read_nothing() {
    const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (nothing < 0) { return; }
    ::dup2(nothing, STDIN_FILENO);
    ::close(nothing);
}

// A crash is an outcome, no occasion for files of hundreds of megabytes.
void dump_no_core() {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
}

}  // namespace

void ignore_signals(std::initializer_list<int> signals) {
    for (const int signal : signals) {
        on_signal(signal, SIG_IGN);  // NOLINT(cppcoreguidelines-pro-type-cstyle-cast): the system's macro
    }
}

void be_worker(pid_t parent, const Descriptor& socket, const Printed& printed, const WorkerGoods& goods,
               const WorkerMain& work) {
    die_with(parent);
    std::stop_source stop;
    stop_of_worker = &stop;
    catch_nothing();
    ignore_signals({SIGINT, SIGPIPE, SIGXFSZ});  // Ctrl-C meets all of a terminal: the program says when to stop
    on_signal(SIGTERM, stop_worker);
    read_nothing();
    printed.divert();
    dump_no_core();
    limit_memory(goods.memory);
    work(socket, printed, Watch(stop.get_token(), goods.told));
#ifdef KREISEL_COVERAGE
    __gcov_dump();
#endif
    ::_exit(0);
}

}  // namespace kreisel
