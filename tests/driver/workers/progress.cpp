// SPDX-License-Identifier: BSD-3-Clause
//
// What a run says of how far it is: parts of cells and of references count, and nothing is taken back.
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include "driver/campaign/campaign.hpp"
#include "driver/campaign/dispatch/effort.hpp"
#include "driver/campaign/workers/forker.hpp"
#include "driver/campaign/workers/message.hpp"
#include "driver/plan/cost.hpp"
#include "driver/plan/plan.hpp"
#include "records/json/strict.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/workers/program_process.hpp"

namespace told_progress {

using namespace kreisel;

// Dies at nine tenths of the first cell, the first time.
class Fragile final : public FakeEngine {
  public:
    using FakeEngine::run;
    Outcome run(const Cell& cell, const Reference* reference, const Watch& watch, SampleSink* samples) const override {
        if (deaths == 0) {
            ++deaths;
            watch.tell(0.9);
            pause_for(0.5);
            ::kill(::getpid(), SIGKILL);
        }
        return FakeEngine::run(cell, reference, watch, samples);
    }
    mutable SharedCount deaths;
};

// All that a run of one cell writes on a terminal; above 1000 s it is one that has a reference.
std::string said(const std::string& method, long steps, double end = 1, const Engine& engine = FakeEngine()) {
    const ScratchFolder scratch;
    nlohmann::json metrics = nlohmann::json::array();  // none: no reference
    if (end > 1000) { metrics.push_back("error.position"); }
    const nlohmann::json config = {
        {"name", "one"},       {"kind", "convergence"}, {"problems", {"heavy_top"}},
        {"methods", {method}}, {"metrics", metrics},    {"time", {{"end", end}, {"steps", steps}}}};
    const Engines engines{engine, engine};
    const Plan plan = plan_of(parse_document("one.json", config.dump()), engines);
    RunSettings settings;
    settings.terminal = true;
    settings.build = "test";
    ::setenv("TERM", "xterm", 1);
    std::ostringstream out;
    const CampaignReport report = run_campaign(plan, engines, scratch / "out", settings, out);
    CHECK(report.counts.ok == 1);
    return out.str();
}

std::vector<double> percentages(const std::string& text) {
    static const std::regex line("one: ([0-9.]+) %, 0/1 cells");
    std::vector<double> all;
    for (std::sregex_iterator at(text.begin(), text.end(), line), end; at != end; ++at) {
        all.push_back(std::stod(at->str(1)));
    }
    return all;
}

std::size_t different(const std::vector<double>& numbers) {
    return std::set<double>(numbers.begin(), numbers.end()).size();
}

TEST_CASE("the outlook of a run counts the parts of jobs at work") {
    Efforts efforts;
    efforts.cells.add(40);
    const Outlook one = outlook(efforts, {{false, 20, 0.5, 30}}, 1);
    CHECK(one.share == Approx(0.25));
    CHECK(one.seconds_left == Approx(90).epsilon(0.02));
    const Outlook two = outlook(efforts, {{false, 20, 0.5, 30}, {false, 20, 0.5, 30}}, 2);
    CHECK(two.share == Approx(0.5));
    CHECK(two.seconds_left == Approx(30).epsilon(0.02));
    // The longer one of two decides.
    CHECK(outlook(efforts, {{false, 10, 0.9, 27}, {false, 30, 0.3, 27}}, 2).seconds_left == Approx(63).epsilon(0.02));
}

TEST_CASE("the outlook of a run takes what is no share for the nearest one") {
    Efforts efforts;
    efforts.cells.add(10);
    for (const double none : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
        CHECK(outlook(efforts, {{false, 5, none, 1}}, 1).share == 0);
    }
    CHECK(outlook(efforts, {{false, 5, 7, 1}}, 1).share == 0.5);
}

TEST_CASE("the outlook of a run knows what was done in vain, and what is dropped") {
    Efforts efforts;
    efforts.cells.add(20);
    efforts.cells.lose(10, 30);
    const Outlook lost = outlook(efforts, {}, 1);
    CHECK(lost.share == 0);
    CHECK(lost.seconds_left == Approx(60).epsilon(0.05));
    efforts.cells.drop(15);
    CHECK(outlook(efforts, {}, 1).seconds_left == Approx(15).epsilon(0.05));
    efforts.cells.drop_rest();
    CHECK(outlook(efforts, {}, 1).share == 0);
    CHECK(outlook(efforts, {}, 1).seconds_left == 0);
}

TEST_CASE("the outlook of a run takes the time left neither from a tiny first cell nor from references alone") {
    Efforts efforts;
    efforts.cells.add(10);
    efforts.cells.end(1e-5, 0.5);
    CHECK(outlook(efforts, {}, 1).seconds_left < 200);
    Efforts after_references;
    after_references.references.add(5);
    after_references.references.end(5, 500);
    after_references.cells.add(10);
    after_references.cells.end(2, 2);
    CHECK(outlook(after_references, {}, 1).seconds_left == Approx(8));
}

TEST_CASE("a cell whose CPU time is taken is done after the last of its rounds") {
    const auto share = [](bool timed, bool repeated, double weight) {
        auto run = std::make_shared<PlannedRun>();
        run->cell.timed = timed;
        run->cell.repeated = repeated;
        PlannedCell planned;
        planned.run = run;
        planned.weight = weight;
        return first_round_share(planned);
    };
    CHECK(share(false, false, 10) == 1);
    CHECK(share(true, false, 10) == Approx(1.0 / timing_rounds));
    // A long run is measured and repeated in the first of five rounds, a short one is repeated in each.
    CHECK(share(false, true, 10) == Approx(2.0 / (timing_rounds + 1)));
    CHECK(share(false, true, 0.3) == Approx(1.0 / timing_rounds));
}

TEST_CASE("workers tell how far they are, each at a place of its own, and leave it when they die") {
    const Forker forker([](const Descriptor& socket, const Printed&, const Watch& watch) {
        while (const auto text = receive_message(socket)) {
            watch.tell(std::stod(*text));
            send_message(socket, "told");
        }
    });
    std::string reason;
    const auto told_by = [&](const Worker& worker, const std::string& number) {
        REQUIRE(worker.told != nullptr);
        send_message(worker.socket, number);
        REQUIRE(receive_message(worker.socket) == "told");
        return worker.told->load();
    };
    const Worker one = forker.spawn(1U << 30U, reason), two = forker.spawn(1U << 30U, reason);
    CHECK(told_by(one, "0.25") == 0.25);
    CHECK(told_by(two, "0.75") == 0.75);
    forker.bury(one);
    CHECK(*one.told == 0.25);
    const Worker three = forker.spawn(1U << 30U, reason);
    CHECK(three.told == one.told);
    CHECK(*three.told == 0);
    CHECK(*two.told == 0.75);
}

TEST_CASE("a share of a part is one of the whole") {
    Share share = 0;
    const Watch whole({}, &share);
    whole.part(0.5, 1).part(0, 0.5).tell(0.5);
    CHECK(share == 0.625);
    whole.part(3, 4).tell(0.25);
    CHECK(share == 3.25);
}

TEST_CASE("the progress of a run comes from within its cells and references") {
    const std::vector<double> of_cell = percentages(said("fake/slow", 700));
    CHECK(different(of_cell) >= 3);
    CHECK(std::is_sorted(of_cell.begin(), of_cell.end()));
    const std::vector<double> of_reference = percentages(said("rkmk/rk4", 2, 1001));
    CHECK(different(of_reference) >= 3);
    const std::vector<double> of_silent = percentages(said("fake/deaf", 500));
    REQUIRE(!of_silent.empty());
    CHECK(different(of_silent) == 1);
}

TEST_CASE("the progress of a run stays where it was while a cell that has lost its worker begins again") {
    const std::string text = said("fake/slow", 600, 1, Fragile());
    const std::vector<double> shown = percentages(text);
    REQUIRE(shown.size() >= 3);
    CHECK(std::is_sorted(shown.begin(), shown.end()));
    CHECK(shown.front() >= 85);
    CHECK(std::count(shown.begin(), shown.end(), shown.front()) >= 3);
}

}  // namespace told_progress
