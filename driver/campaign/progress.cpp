// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <ostream>
#include <string_view>
#include <utility>

#include "driver/plan/estimate/amounts.hpp"

namespace kreisel {

namespace {

constexpr double terminal_interval = 0.2, log_interval = 5.0;  // s

bool rewrites_lines() {
    const char* kind = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): no other thread is there
    return kind != nullptr && *kind != '\0' && std::string_view(kind) != "dumb";
}

// 0 where standard error is no terminal.
unsigned terminal_columns() {
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace

std::string cut_to_terminal(std::string text, unsigned columns) {
    // A full line would make some terminals begin another one.
    if (columns > 1 && text.size() >= columns) { text.resize(columns - 1); }
    return text;
}

Progress::Progress(std::ostream& out, std::string name, bool terminal)
    : out_(out), name_(std::move(name)), terminal_(terminal), silent_(terminal && !rewrites_lines()) {}

bool Progress::is_due() const {
    const double interval = terminal_ ? terminal_interval : log_interval;
    return !silent_ && std::chrono::duration<double>(Clock::now() - last_).count() >= interval;
}

void Progress::show(const ProgressState& state) {
    if (!is_due()) { return; }
    last_ = Clock::now();
    // Rounded down: 100 % is the end.
    std::string text =
        fmt::format("{}: {:.1f} %, {}/{} cells", name_, std::floor(1000 * state.share) / 10, state.done, state.total);
    if (state.references_done < state.references) {
        text += fmt::format(", {}/{} reference solutions", state.references_done, state.references);
    }
    if (state.failed > 0) { text += fmt::format(", {} failed", state.failed); }
    if (state.share > 0 && state.seconds_left > 0) { text += ", about " + duration_text(state.seconds_left) + " left"; }
    if (terminal_) {
        out_ << "\r\x1b[K" << cut_to_terminal(std::move(text), terminal_columns())
             << std::flush;  // erase to the end of the line
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
