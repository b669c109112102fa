// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/progress.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "driver/plan/estimate/amounts.hpp"

namespace kreisel {

namespace {

constexpr double terminal_interval = 0.2, log_interval = 5.0;  // s

}  // namespace

Progress::Progress(std::ostream& out, std::string name, bool terminal)
    : out_(out), name_(std::move(name)), terminal_(terminal), start_(Clock::now()), last_(start_) {}

void Progress::show(const ProgressState& state) {
    const auto now = Clock::now();
    const auto seconds = [](Clock::duration span) { return std::chrono::duration<double>(span).count(); };
    if (seconds(now - last_) < (terminal_ ? terminal_interval : log_interval)) { return; }
    last_ = now;
    std::string text = fmt::format("{}: {}/{} cells", name_, state.done, state.total);
    if (state.references_done < state.references) {
        text += fmt::format(", {}/{} reference solutions", state.references_done, state.references);
    }
    if (state.failed > 0) { text += fmt::format(", {} failed", state.failed); }
    if (state.weight_done > 0 && state.weight_total > state.weight_done) {
        const double left = seconds(now - start_) * (state.weight_total - state.weight_done) / state.weight_done;
        text += ", about " + duration_text(left) + " left";
    }
    if (terminal_) {
        out_ << "\r\x1b[K" << text << std::flush;  // erase to the end of the line
        line_open_ = true;
    } else {
        out_ << text << std::endl;
    }
}

void Progress::clear() {
    if (line_open_) {
        out_ << "\r\x1b[K" << std::flush;
        line_open_ = false;
    }
}

}  // namespace kreisel
