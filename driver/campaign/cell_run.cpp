// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/cell_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <new>

#include "records/cell/line.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

/// What of an outcome is not a finite number; empty: nothing.
std::string not_finite(const Outcome& outcome) {
    for (const auto& [name, number] : outcome.metrics) {
        if (!std::isfinite(number.value)) { return fmt::format("{} is {}", name, number.text); }
    }
    return "";
}

/// A cell whose steps all succeeded, but whose numbers are none: a failure of its own kind, not a missing number.
Outcome checked(Outcome outcome) {
    const std::string what = outcome.status == status::ok ? not_finite(outcome) : "";
    if (what.empty()) { return outcome; }
    outcome.status = "non_finite";
    outcome.detail = what + ", not a finite number";
    std::erase_if(outcome.metrics, [](const auto& metric) { return !std::isfinite(metric.second.value); });
    return outcome;
}

}  // namespace

Outcome ended(std::string status, std::string detail) {
    Outcome outcome;
    outcome.status = std::move(status);
    outcome.detail = std::move(detail);
    return outcome;
}

Outcome run_cell(const PlannedCell& planned, const Engine& engine, const Reference* reference, const Watch& watch,
                 SampleSink* samples) {
    try {
        return checked(engine.run(planned.cell(), reference, watch, samples));
    } catch (const FileError&) { throw; } catch (const std::bad_alloc&) {
        return ended(status::out_of_memory, "");
    } catch (const std::exception& error) { return ended(status::exception, error.what()); } catch (...) {
        return ended(status::exception, not_an_exception);
    }
}

CellRecord record_of_run(const PlannedCell& planned, const Outcome& outcome, const Reference* reference,
                         const std::string& samples_sum) {
    const bool thrown = outcome.status == status::exception || outcome.status == status::out_of_memory;
    return record_of(planned, outcome, reference, thrown ? "" : samples_sum);
}

}  // namespace kreisel
