// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/workers/forker.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <vector>

#include "driver/campaign/workers/control.hpp"
#include "driver/campaign/workers/limits.hpp"
#include "driver/campaign/workers/parent.hpp"
#include "driver/campaign/workers/worker_process.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

constexpr int longest_farewell = 1000;  // ms
constexpr pid_t none = 0;

/// The process that forks.
class Nursery {
  public:
    Nursery(const Descriptor& control, const Shares& shares, const WorkerMain& work)
        : control_(control), shares_(shares), work_(work) {}

    /// Until the program closes its end or is gone.
    void serve() {
        while (const auto request = receive_request(control_)) {
            if (request->kind == Request::Kind::spawn) { spawn(request->memory); }
            if (request->kind == Request::Kind::release) { release(request->process); }
            if (request->kind == Request::Kind::bury) { bury(request->process); }
            if (request->kind == Request::Kind::interrupt) { signal_all(SIGTERM); }
        }
        signal_all(SIGKILL);
        for (const pid_t worker : workers_) {
            if (worker != none) { ::waitpid(worker, nullptr, 0); }
        }
    }

  private:
    void spawn(std::uint64_t memory) {
        int ends[2] = {-1, -1};
        const bool connected = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0;
        const Descriptor ours(ends[0]);
        Descriptor theirs(ends[1]);
        const Printed printed = connected ? Printed::make() : Printed(Descriptor());
        const auto place = free_place();
        Share* told = shares_.place(static_cast<std::size_t>(place - workers_.begin()));
        if (told != nullptr) { *told = 0; }
        const pid_t nursery = ::getpid();
        const pid_t worker = printed.valid() ? ::fork() : -1;
        if (worker == 0) {
            ::close(control_.number());
            ::close(ours.number());
            be_worker(nursery, theirs, printed, {memory, told}, work_);
        }
        if (worker < 0) { return send_answer(control_, {-1, errno, 0}, {}); }
        *place = worker;
        send_answer(control_, {worker, 0, static_cast<std::size_t>(place - workers_.begin())},
                    {ours.number(), printed.number()});
    }

    // The first that no worker has.
    std::vector<pid_t>::iterator free_place() {
        const auto place = std::find(workers_.begin(), workers_.end(), none);
        return place != workers_.end() ? place : workers_.insert(workers_.end(), none);
    }

    // The worker sees that its socket is closed; what watches it, a profiler or counts of coverage, then has work to
    // do.
    void release(pid_t worker) {
        const Descriptor process(static_cast<int>(::syscall(SYS_pidfd_open, worker, 0)));
        pollfd end{process.number(), POLLIN, 0};
        ::poll(&end, 1, longest_farewell);  // of no descriptor: the time passes
        bury(worker);
    }

    void bury(pid_t worker) {
        int status = 0;
        ::kill(worker, SIGKILL);  // one that has ended keeps the status it ended with
        while (::waitpid(worker, &status, 0) < 0 && errno == EINTR) {}
        std::replace(workers_.begin(), workers_.end(), worker, none);
        send_answer(control_, {worker, status, 0}, {});
    }

    void signal_all(int signal) const {
        for (const pid_t worker : workers_) {
            if (worker != none) { ::kill(worker, signal); }  // none is reaped but by bury
        }
    }

    const Descriptor& control_;
    const Shares& shares_;
    const WorkerMain& work_;
    std::vector<pid_t> workers_;  // by place
};

[[noreturn]] void be_nursery(pid_t program, const Descriptor& control, const Shares& shares, const WorkerMain& work) {
    die_with(program);
    ignore_signals({SIGINT, SIGTERM, SIGPIPE, SIGXFSZ});
    Nursery(control, shares, work).serve();
    ::_exit(0);
}

[[noreturn]] void fail(int error) {
    throw FileError(fmt::format("the process that starts workers cannot be made: {}", std::strerror(error)));
}

}  // namespace

Forker::Forker(const WorkerMain& work) {
    int ends[2] = {-1, -1};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) { fail(errno); }
    control_ = Descriptor(ends[0]);
    const Descriptor theirs(ends[1]);
    std::cout.flush();  // what is pending would be printed by every child as well
    std::fflush(nullptr);
    const pid_t program = ::getpid();
    process_ = ::fork();
    if (process_ < 0) { fail(errno); }
    if (process_ > 0) { return; }
    ::close(control_.number());
    be_nursery(program, theirs, shares_, work);
}

Forker::~Forker() {
    control_.close();
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {}
}

Worker Forker::spawn(std::uint64_t memory, std::string& reason) const {
    send_request(control_, {Request::Kind::spawn, -1, memory});
    ReceivedAnswer received = receive_answer(control_);
    const bool whole = received.answer.process > 0 && received.descriptors.size() == 2;
    Worker worker;
    if (whole) {
        worker.process = received.answer.process;
        worker.socket = std::move(received.descriptors[0]);
        worker.printed = Printed(std::move(received.descriptors[1]));
        worker.told = shares_.place(received.answer.place);
    } else if (received.answer.process > 0) {  // it is there, but this process cannot have its descriptors
        worker.process = received.answer.process;
        bury(worker);
        worker.process = -1;
        reason = std::strerror(EMFILE);
    } else {
        reason = std::strerror(received.answer.status);
    }
    return worker;
}

void Forker::release(Worker& worker) const {
    worker.socket.close();
    send_request(control_, {Request::Kind::release, worker.process, 0});
    receive_answer(control_);
}

int Forker::bury(const Worker& worker) const {
    send_request(control_, {Request::Kind::bury, worker.process, 0});
    return receive_answer(control_).answer.status;
}

void Forker::interrupt() const { send_request(control_, {Request::Kind::interrupt, -1, 0}); }

}  // namespace kreisel
