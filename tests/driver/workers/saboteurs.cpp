// SPDX-License-Identifier: BSD-3-Clause
#include "tests/driver/workers/saboteurs.hpp"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <thread>

namespace kreisel {

namespace {

constexpr std::size_t megabyte = 1U << 20U;

volatile int sink = 0;  // what is written to it is not optimised away

void segfault() { *static_cast<volatile int*>(nullptr) = 1; }

int overflow(int depth) {
    volatile char room[4096] = {};
    room[depth % 4096] = 1;
    return depth < 0 ? 0 : room[depth % 4096] + overflow(depth + 1);
}

void loop() {
    for (;;) { sink = sink + 1; }
}

// So many blocks of a megabyte, all of them used.
void allocate(std::size_t blocks) {
    std::vector<std::unique_ptr<char[]>> all;
    for (std::size_t i = 0; i < blocks; ++i) {
        all.push_back(std::make_unique<char[]>(megabyte));
        std::memset(all.back().get(), 1, megabyte);
        sink = all.back()[i % megabyte];
    }
}

void hoard() { allocate(1U << 20U); }

void print_much() {
    const std::string line(999, 'x');
    for (int i = 0; i < 1000; ++i) { std::puts(line.c_str()); }
}

void close_all() {
    for (int i = 0; i < 1024; ++i) { ::close(i); }
}

void sleep_long() { std::this_thread::sleep_for(std::chrono::minutes(10)); }

const std::map<std::string, std::function<void()>>& deeds() {
    static const std::map<std::string, std::function<void()>> all = {
        {"segfault", segfault},
        {"abort", [] { std::abort(); }},
        {"terminate", [] { std::terminate(); }},
        {"exit", [] { std::exit(3); }},
        {"overflow", [] { sink = overflow(0); }},
        {"loop", loop},
        {"hoard", hoard},
        {"greedy", [] { allocate(100); }},
        {"throw", [] { throw std::runtime_error("thrown on purpose"); }},
        {"print", [] { std::printf("a line\nand \"another\"\n"), std::fputs("an error", stderr); }},
        {"flood", print_much},
        {"close", close_all},
        {"kill", [] {}},
        {"sleep", [] {}},
    };
    return all;
}

const std::string family = "sabotage/";

}  // namespace

std::vector<MethodDescription> Saboteurs::methods() const {
    std::vector<MethodDescription> all = FakeEngine::methods();
    for (const auto& [name, deed] : deeds()) {  // as many stages as rkmk/rk4, so that they start as early
        all.push_back({.name = family + name, .order = 1, .summary = "evil", .stages = 4});
    }
    return all;
}

std::string Saboteurs::skip_reason(const Cell& cell) const {
    const auto mass = cell.parameters.find("mass");
    const bool is_usual = mass == cell.parameters.end() || mass->second == ParameterValue(15.0);
    return cell.method.starts_with(family) && !is_usual ? "a few are enough" : FakeEngine::skip_reason(cell);
}

Outcome Saboteurs::run(const Cell& cell, const Reference* reference, const Watch& watch, SampleSink* samples) const {
    if (!cell.method.starts_with(family)) { return FakeEngine::run(cell, reference, watch, samples); }
    const std::string name = cell.method.substr(family.size());
    deeds().at(name)();
    if (name == "kill" && killed == 0) {
        ++killed;
        ::kill(::getpid(), SIGKILL);
    }
    if (name == "sleep") {
        processes.push_back(::getpid());
        sleep_long();
    }
    return FakeEngine::run(cell, reference, watch, samples);
}

Reference Saboteurs::reference(const std::string& problem, const ParameterValues& parameters, const BeginState* begin,
                               double t_end, long samples, const Watch& watch) const {
    static const char* const by_mass[] = {"", "segfault", "loop", "hoard", "throw"};
    const auto mass = parameters.find("mass");
    const double value = mass == parameters.end() ? 0 : std::get<double>(mass->second);
    for (int i = 1; i <= 4 && problem == "free_top"; ++i) {
        if (value == i) { deeds().at(by_mass[i])(); }
    }
    return FakeEngine::reference(problem, parameters, begin, t_end, samples, watch);
}

}  // namespace kreisel
