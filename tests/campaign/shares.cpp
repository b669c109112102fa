// SPDX-License-Identifier: BSD-3-Clause
//
// What runs and references tell of how far they are: steps of one size, or simulated time, rounds included.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <set>
#include <thread>

#include "tests/campaign/acceptance.hpp"

namespace told_shares {

using namespace kreisel;
using namespace kreisel::acceptance;

/// Reads the share at each sample.
struct ShareReader final : SampleSink {
    void begin(const std::vector<Column>&) override {}
    void add(const std::string& row) override {
        times.push_back(std::stod(row));
        shares.push_back(told);
    }

    Share told = 0;
    std::vector<double> times, shares;
};

constexpr double t_end = 0.125;
constexpr long intervals = 16;

Cell spinning_top(const std::string& method) {
    Cell cell{.problem = "heavy_top",
              .parameters = defaults("heavy_top"),
              .formulation = "SO3xR3",
              .method = method,
              .options = {},
              .projection = "none",
              .projection_options = {},
              .t_end = t_end,
              .samples = intervals,
              .metrics = {}};
    for (const MethodDescription& description : engine_binary64().methods())
        if (description.name == cell.method) cell.options = standard_options(description);
    return cell;
}

/// Runs a cell; its shares must rise to `end` in step with time, but for `late`.
void require_even(const Engine& engine, const Cell& cell, double end, double late) {
    ShareReader reader;
    REQUIRE(engine.run(cell, nullptr, Watch({}, &reader.told), &reader).status == "ok");
    REQUIRE(reader.shares.size() == intervals + 1);
    CHECK(reader.told == 1);
    CHECK(std::is_sorted(reader.shares.begin(), reader.shares.end()));
    for (std::size_t i = 0; i < reader.shares.size(); ++i) {
        const double expected = end * reader.times[i] / t_end;
        INFO(reader.times[i] << " s: " << reader.shares[i]);
        CHECK(reader.shares[i] <= expected + 1e-12);
        CHECK(reader.shares[i] >= expected - late);
    }
}

TEST_CASE("a run of steps of one size tells the share of its steps", "[campaign]") {
    Cell cell = spinning_top("rkmk/rk4");
    cell.steps = 256 * intervals;
    require_even(engine_binary64(), cell, 1, 1.0 / intervals);
    cell.steps = 16 * intervals;
    require_even(engine_binary128(), cell, 1, 1.0 / intervals);
}

TEST_CASE("a run of steps to a tolerance tells the share of its time", "[campaign]") {
    Cell cell = spinning_top("commutator_free/cf3");
    cell.steps = 0;
    cell.tolerance = 1e-9;
    require_even(engine_binary64(), cell, 1, 0.25);
}

TEST_CASE("a run that is repeated is half done when it has been measured", "[campaign]") {
    Cell cell = spinning_top("rkmk/rk4");
    cell.steps = 256 * intervals;
    cell.repeated = true;
    require_even(engine_binary64(), cell, 0.5, 0.5 / intervals);
}

TEST_CASE("a run whose steps are measured at both ends is not done when it has taken its steps", "[campaign]") {
    Cell cell = spinning_top("rkmk/rk4");
    cell.steps = 2 * intervals;
    cell.metrics = {"structure.symplectic"};
    ShareReader reader;
    REQUIRE(engine_binary64().run(cell, nullptr, Watch({}, &reader.told), &reader).status == "ok");
    CHECK(reader.told == 1);
    CHECK(std::is_sorted(reader.shares.begin(), reader.shares.end()));
    CHECK(reader.shares.at(1) > 0.25);
    CHECK(reader.shares.back() < 0.75);
}

TEST_CASE("a run whose time is taken tells when it has come to its end", "[campaign]") {
    Cell cell = spinning_top("rkmk/rk4");
    cell.steps = 64;
    cell.samples = 0;
    cell.timed = true;
    Share first = 0, further = 0, stopped = 0;
    REQUIRE(engine_binary64().run(cell, nullptr, Watch({}, &first)).status == "ok");
    CHECK(first == 1);
    REQUIRE(engine_binary64().run_time(cell, Watch({}, &further)).has_value());
    CHECK(further == 1);
    std::stop_source source;
    source.request_stop();
    CHECK(engine_binary64().run(cell, nullptr, Watch(source.get_token(), &stopped)).status == "interrupted");
    CHECK(stopped == 0);
}

TEST_CASE("a reference tells how far it is, in both of its routes", "[campaign]") {
    for (const long samples : {0L, 4L}) {
        INFO(samples << " samples");
        Share told = 0;
        std::vector<double> seen;
        {
            const std::jthread reader([&](const std::stop_token& stop) {
                while (!stop.stop_requested()) {
                    seen.push_back(told);
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                }
            });
            engine_binary128().reference("double_pendulum", defaults("double_pendulum"), 0.5, samples,
                                         Watch({}, &told));
        }
        CHECK(told == 1);
        CHECK(std::is_sorted(seen.begin(), seen.end()));
        CHECK(std::set<double>(seen.begin(), seen.end()).size() >= 5);
    }
}

}  // namespace told_shares
