// SPDX-License-Identifier: BSD-3-Clause
//
// Result lines, journals and tables.
#include <catch2/catch.hpp>
#include <fstream>
#include <limits>
#include <sstream>

#include "driver/plan/plan.hpp"
#include "records/cell/line.hpp"
#include "records/cell/read_table.hpp"
#include "records/cell/table.hpp"
#include "records/journal.hpp"
#include "records/json/strict.hpp"
#include "records/reference_store.hpp"
#include "records/sums/summed_text.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/hash.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

Plan small_plan(const std::string& precision) {
    return plan_of(parse_document("t", R"({"name": "n", "kind": "convergence", "precision": ")" + precision + R"(",
        "problems": [{"name": "heavy_top", "label": "a,\"status\":\"ok\" b"}], "methods": ["rkmk/rk4", "rkmk/midpoint"],
        "time": {"end": 1, "steps": 4}})"),
                   one_engine);
}

CellRecord finished(const PlannedCell& planned) {
    const Reference reference =
        plain_engine.reference(planned.cell().problem, planned.cell().parameters, planned.cell().t_end, {});
    return record_of(planned, plain_engine.run(planned.cell(), &reference, {}), &reference);
}

/// An object without its closing one.
std::string without_brace(const std::string& object) { return object.substr(0, object.size() - 1); }

std::string written_table(const std::vector<CellRecord>& records, const TableUnits& units) {
    ResultsTable table(units);
    for (const CellRecord& record : records) { table.row(field_values(result_text(record))); }
    std::string text = table.header();
    for (const CellRecord& record : records) { text += table.row(field_values(result_text(record))); }
    return text;
}

}  // namespace

TEST_CASE("a result line holds what the contract says") {
    const Plan plan = small_plan("double");
    const auto line = nlohmann::json::parse(result_text(finished(plan.cells[0])));
    for (const char* key : {"cell", "problem", "label", "parameters", "formulation", "method", "options", "projection",
                            "precision", "steps", "h", "t_end", "status", "final", "metrics", "reference", "cost"}) {
        INFO(key);
        CHECK(line.contains(key));
    }
    CHECK(line["h"] == 0.25);
    CHECK(line["final"]["bodies"][0]["R"][2][2] == 1);
    CHECK(line["final"]["multipliers"][0] == 1.0 / 3);
    CHECK(line["metrics"]["error.position"] == 1.0 / 256);
    CHECK(line["reference"]["error"]["error.position"] == 1e-20);
    CHECK_FALSE(line["cost"].contains("cpu_s"));
    const auto journal = nlohmann::json::parse(journal_line(finished(plan.cells[0]), "b"));
    CHECK(journal["cost"]["cpu_s"].get<double>() > 0);
    CHECK(journal["build"] == "b");
}

TEST_CASE("quad numbers are written as decimal strings") {
    const auto line = nlohmann::json::parse(result_text(finished(small_plan("quad").cells[0])));
    CHECK(line["final"]["multipliers"][1] == "-1e-30");
    CHECK(line["metrics"]["error.position"].is_string());
}

TEST_CASE("a number that is not finite is never written") {
    const PlannedCell planned = small_plan("double").cells[0];
    Outcome outcome = plain_engine.run(planned.cell(), nullptr, {});
    outcome.metrics.emplace_back("defect.position", Number{std::numeric_limits<double>::quiet_NaN(), "nan"});
    CHECK_THROWS_AS(result_text(record_of(planned, outcome, nullptr)), std::logic_error);
}

TEST_CASE("a journal line comes back as the record it was made from") {
    for (const char* precision : {"double", "quad"}) {
        const CellRecord cell = finished(small_plan(precision).cells[0]);
        const auto again = read_journal_line(journal_line(cell, "build"), "build");
        REQUIRE(again);
        CHECK(again->identity == cell.identity);
        CHECK(again->times.cpu_s == cell.times.cpu_s);
        CHECK(result_text(*again) == result_text(cell));
        CHECK(journal_line(*again, "build") == journal_line(cell, "build"));
        CHECK_FALSE(read_journal_line(journal_line(cell, "build"), "another build"));
        CHECK(journalled_cell(journal_line(cell, "another build")) == cell.identity.cell);
    }
}

TEST_CASE("every member of a line comes back with its bytes") {
    const std::string line =
        R"({"cell":"1f","problem":"p","label":"a \"b\"","series":"s","parameters":{"mass":15,"lever":[-0,1e-05,0],)"
        R"("J":[[1,0,0],[0,2,0],[0,0,3]],"flag":true,"bodies":[{"name":"rod"}]},"formulation":"SE3","method":"m",)"
        R"("options":{"coordinates":"exp","q":2,"rho":0.5,"yes":false},)"
        R"("order":{"configuration":4,"velocity":3,"multipliers":2},"projection":"none","projection_options":{},)"
        R"("precision":"quad","steps":4,"h":0.25,"t_end":1,"status":"left_chart","detail":"why","steps_done":2,)"
        R"("t_reached":0.5,"bodies":3,"final":{"t":"1","bodies":[{"name":"rod","x":["-0","1e-05","3"],)"
        R"("R":[["1","0","0"],["0","1","0"],["0","0","1"]],"v":["1","2","3"],"omega":["4","5","6"]}],)"
        R"("multipliers":["7"],"multiplier_names":["lambda.pin.1 [N]"],)"
        R"("reactions":[{"joint":"pin","force":["1","2","3"],"torque":["4","5","6"],"driving_force":"7",)"
        R"("driving_torque":"8","unique":false}],)"
        R"("theta":["8"],"turns":[-2]},)"
        R"("constraints":{"rows":3,"rank":2,"condition":1.5,"redundant":["pin.2"],"least_norm_multipliers":["1"]},)"
        R"("metrics":{"error.position":"1.5e-20"},"lost":{"integral":"energy","share":0.25},)"
        R"("reference":{"error":{"error.position":1e-25},"horizon":10,"past_horizon":true},)"
        R"("trajectory":"trajectories/1f.csv","trajectory_sum":"2e",)"
        R"("cost":{"evaluations":1,"projection_iterations":2,"output_evaluations":3}})";
    const CellRecord record = read_record(line);
    CHECK(result_text(record) == line);
    CHECK(parse_exactly(record.identity.parameters).find("lever")->elements[0].text == "-0");
    CHECK(record.outcome.final->turns == std::vector<long>{-2});
    for (const std::string& damaged : {line.substr(0, line.size() - 1), line + "}", std::string("{}"),
                                       std::string(R"({"cell":"1","problem":"p","status":7})")}) {
        CHECK_THROWS_AS(read_record(damaged), std::invalid_argument);
    }
}

TEST_CASE("a line of the journal is passed on as what the record says, with the identity that it is given") {
    for (const char* precision : {"double", "quad"}) {
        const Plan plan = small_plan(precision);
        CellRecord failed = finished(plan.cells[1]), timed = finished(plan.cells[0]);
        failed.outcome.status = "left_chart";
        failed.outcome.detail = "a \"b\", {c}";
        timed.times = {0.5, 1e-3, 1024, 2.5};
        CellRecord skipped =
            record_of(plan.cells[0], Outcome{.status = "skipped", .detail = "it does not apply"}, nullptr);
        for (CellRecord* record : {&failed, &timed, &skipped}) {
            const std::string journalled = journal_line(*record, "b");
            CHECK(ResultLine(record->identity, journalled).text() == with_sum(without_brace(result_text(*record))));
            record->identity.label = "another, \"label\"";
            const ResultLine passed_on(record->identity, journalled);
            const std::string& line = passed_on.text();
            CHECK(passed_on.values() == field_values(line));
            CHECK(std::string(before_sum(line)) + "}" == result_text(*record));
            CHECK(sum_state(line) == SumState::holds);
            CHECK(line.find("cpu_s") == std::string::npos);
            CHECK(is_line_of(journalled, record->identity.cell));
            CHECK_FALSE(is_line_of(journalled, std::string(16, '0')));
            CHECK_THROWS_AS(ResultLine(record->identity, journalled.substr(0, 200)), std::invalid_argument);
        }
    }
}

TEST_CASE("a journal line that is cut or changed anywhere is not believed") {
    const std::string line = journal_line(finished(small_plan("double").cells[0]), "build");
    for (std::size_t i = 0; i < line.size(); ++i) {
        CHECK_FALSE(read_journal_line(line.substr(0, i), "build"));
        CHECK_FALSE(journalled_cell(line.substr(0, i)));
        std::string flipped = line;
        flipped[i] = static_cast<char>(flipped[i] ^ 1);
        CHECK_FALSE(read_journal_line(flipped, "build"));
        CHECK_FALSE(journalled_cell(flipped));
    }
}

TEST_CASE("a torn journal keeps its good lines and says what it left out") {
    const ScratchFolder scratch;
    const Plan plan = small_plan("double");
    const std::string first = journal_line(finished(plan.cells[0]), "b"),
                      second = journal_line(finished(plan.cells[1]), "b");
    scratch.file("journal.jsonl", first + "\nrubbish\n" + second.substr(0, 100));
    const JournalContents contents_read = read_journals(scratch / "", "b");
    CHECK(contents_read.cells.size() == 1);
    REQUIRE(contents_read.complaints.size() == 2);
    CHECK(contents_read.complaints[0].find("journal.jsonl:2:") != std::string::npos);
    CHECK(contents_read.complaints[1].find("torn last line") != std::string::npos);
    mend_journal(scratch / "journal.jsonl");
    CHECK(contents(scratch / "journal.jsonl") == first + "\nrubbish\n");
}

TEST_CASE("cells of other builds are distinguished from damage, and removed when a journal is pruned") {
    const ScratchFolder scratch;
    const Plan plan = small_plan("double");
    const CellRecord first = finished(plan.cells[0]), second = finished(plan.cells[1]);
    const std::string mine = journal_line(first, "b") + "\n";
    scratch.file("journal.jsonl",
                 journal_line(first, "a") + "\n" + mine + "rubbish\n" + journal_line(second, "a") + "\n");
    const JournalContents contents_read = read_journals(scratch / "", "b");
    CHECK(contents_read.cells.size() == 1);
    CHECK(contents_read.foreign == std::set<std::string>{second.identity.cell});
    CHECK(contents_read.complaints.size() == 1);
    prune_journal(scratch / "journal.jsonl", "b");
    CHECK(contents(scratch / "journal.jsonl") == mine);
}

TEST_CASE("the table has one column for each parameter, option and number, with units, and quotes what it must") {
    const auto record = [](const std::string& members) {
        return read_record(R"({"cell":"1","problem":"top","status":"ok")" + members + "}");
    };
    const std::string table =
        written_table({record(R"(,"label":"a,\"b\"","options":{"q":2},"parameters":{"mass":15,"lever":[0,1]},"h":0.5,
                "metrics":{"error.position":1e-05},
                "final":{"t":1,"multipliers":[3],"multiplier_names":["lambda.pin.1 [N]"]})"),
                       record(R"(,"label":"c","options":{"w":"x"},"precision":"quad",
                "metrics":{"invariant.area.slope":"0.30000000000000000000001"})")},
                      {{{"invariant.area", "m^2"}}, {{"top", {{"mass", "kg"}, {"lever", "m"}}}}});
    std::istringstream lines(table);
    std::string header, first, second;
    std::getline(lines, header), std::getline(lines, first), std::getline(lines, second);
    CHECK(header ==
          "cell,problem,label,parameter.mass [kg],parameter.lever.1 [m],parameter.lever.2 [m],formulation,method,"
          "option.q,option.w,projection,precision,steps,h [s],t_end [s],status,error.position [m],"
          "invariant.area.slope [m^2/s],final.t [s],final.lambda.pin.1 [N]");
    CHECK(first == "1,top,\"a,\"\"b\"\"\",15,0,1,,,2,,,,0,0.5,0,ok,1e-05,,1,3");
    CHECK(second == "1,top,c,,,,,,,x,,quad,0,0,0,ok,,0.30000000000000000000001,,");
}

TEST_CASE("a row has its own fields, whatever it has in common with the one before") {
    ResultsTable table({{}, {{"a", {{"mass", "kg"}}}, {"b", {{"mass", "t"}}}}});
    const std::vector<std::pair<std::string, std::string>> rows = {
        {R"({"cell":"1","problem":"a","parameters":{"mass":1},"status":"ok"})", "1,a,1,,ok,\n"},
        {R"({"cell":"2","problem":"a","parameters":{"mass":1},"status":"ok"})", "2,a,1,,ok,\n"},
        {R"({"cell":"3","problem":"b","parameters":{"mass":1},"status":"ok"})", "3,b,,1,ok,\n"},
        {R"({"cell":"4","problem":"b","status":"left_chart","detail":"x, y"})", "4,b,,,left_chart,\"x, y\"\n"},
        {R"({"cell":"5","problem":"b","status":"left_chart"})", "5,b,,,left_chart,\n"},
        {R"({"cell":"6","problem":"a","parameters":{"mass":1},"status":"ok"})", "6,a,1,,ok,\n"}};
    for (const auto& row : rows) { table.row(field_values(row.first)); }
    CHECK(table.header() == "cell,problem,parameter.mass [kg],parameter.mass [t],status,detail\n");
    for (const auto& [line, row] : rows) { CHECK(table.row(field_values(line)) == row); }
}

TEST_CASE("a table comes back as the records it was made from, as far as it holds them") {
    for (const char* precision : {"double", "quad"}) {
        std::vector<CellRecord> records;
        for (const PlannedCell& planned : small_plan(precision).cells) { records.push_back(finished(planned)); }
        records[1].outcome = {};
        records[1].outcome.status = "left_chart";
        records[1].identity.label = "12";
        records[1].outcome.detail = "a, \"b\"\nc";
        records[0].outcome.final->reactions = {{"pin", {}, {}}, {"motor", {}, {}}};
        records[0].outcome.final->reactions[1].driving_force = Number{2, "2"};
        records[0].outcome.final->reactions[1].driving_torque = Number{-3, "-3"};
        records[0].outcome.final->turns = {-1};
        records[0].outcome.final->theta = {{0.5, "0.5"}};
        const TableUnits units{{}, {{"heavy_top", {{"mass", "kg"}, {"inertia", "kg m^2"}}}}};
        const auto again = read_results_table(written_table(records, units));
        REQUIRE(again.size() == 2);
        CHECK(written_table(again, units) == written_table(records, units));
        for (std::size_t i = 0; i < 2; ++i) {
            CellIdentity identity = records[i].identity;
            identity.order.reset();  // in JSON lines only
            CHECK(again[i].identity == identity);
            CHECK(again[i].outcome.detail == records[i].outcome.detail);
        }
        CHECK(again[0].outcome.final->bodies[0].R[8].text == "1");
        CHECK(again[0].outcome.final->turns == std::vector<long>{-1});
        CHECK_FALSE(again[0].outcome.final->reactions.at(0).driving_force);
        CHECK(again[0].outcome.final->reactions.at(1).driving_force->text == "2");
        CHECK(again[0].outcome.final->reactions.at(1).driving_torque->text == "-3");
    }
}

TEST_CASE("a damaged table is refused with its row and title") {
    const std::string table = written_table({finished(small_plan("double").cells[0])}, {});
    CHECK_THROWS_WITH(read_results_table(table + "1,2\n"), Catch::Contains("row 2") && Catch::Contains("fields"));
    CHECK_THROWS_WITH(read_results_table("cell,problem,status,steps\n1,p,ok,some\n"), Catch::Contains("whole number"));
    CHECK_THROWS_WITH(read_results_table("cell,problem,status,final.top.y.1 [m]\n1,p,ok,2\n"),
                      Catch::Contains("top.y.1"));
    CHECK_THROWS_AS(read_results_table("cell\n\"1"), std::invalid_argument);
}

TEST_CASE("the table leaves out final states of more than 16 bodies") {
    CellRecord record = finished(small_plan("double").cells[0]);
    CHECK(written_table({record}, {}).find("final.top.R.1.1 [1]") != std::string::npos);
    record.outcome.final->bodies.resize(most_bodies_in_table + 1, record.outcome.final->bodies.front());
    CHECK(written_table({record}, {}).find("final.") == std::string::npos);
}

TEST_CASE("references are read back as they were stored, and only for the same content and code") {
    const ScratchFolder scratch;
    const Plan plan = small_plan("double");
    PlannedReference planned = plan.references.begin()->second;
    const Reference reference = plain_engine.reference("heavy_top", planned.parameters, planned.t_end, 2, {});
    const auto file = scratch / "r.json";
    const std::string text = stored_reference(planned, reference, "b").text;
    scratch.file("r.json", text);
    const auto stored = load_reference(file, planned, "b");
    REQUIRE(stored);
    CHECK(stored->text == text);
    const Reference& again = stored->reference;
    CHECK(again.state.bodies[0].x[1].text == reference.state.bodies[0].x[1].text);
    CHECK(again.state.bodies[0].x[1].value == reference.state.bodies[0].x[1].value);
    CHECK(again.state.multipliers.size() == 3);
    CHECK(again.error.at("error.position").text == "1e-20");
    REQUIRE(again.samples.size() == 2);
    CHECK(again.samples[0].state.t.value == 0.5);
    CHECK(again.samples[0].state.bodies[0].x[1].text == reference.samples[0].state.bodies[0].x[1].text);
    CHECK(again.samples[1].error.at("error.position").text == "1e-20");
    CHECK(again.error.at("error.position.max").text == "1e-20");
    CHECK(again.horizon == 50);
    CHECK(again.route == "fake");
    const auto json = nlohmann::json::parse(text);
    for (const char* key : {"version", "commit", "compiler", "computed"}) { CHECK(json["program"][key].is_string()); }
    CHECK_FALSE(load_reference(file, planned, "c"));
    CHECK(load_reference(file, planned, ""));
    CHECK_FALSE(load_reference(scratch / "absent", planned, "b"));
    planned.content = "{}";
    CHECK_FALSE(load_reference(file, planned, "b"));
    for (std::size_t i = 0; i < text.size(); i += 7) {
        scratch.file("r.json", text.substr(0, i));
        CHECK_FALSE(load_reference(file, plan.references.begin()->second, "b"));
        std::string flipped = text;
        flipped[i] = static_cast<char>(flipped[i] ^ 1);
        scratch.file("r.json", flipped);
        CHECK_FALSE(load_reference(file, plan.references.begin()->second, ""));
    }
    const std::string other = R"({"of":{},"format":7)";
    scratch.file("r.json", other + R"(,"sum":")" + hash_text(other) + "\"}\n");
    CHECK_FALSE(load_reference(file, plan.references.begin()->second, ""));
}

TEST_CASE("files are whole or absent, and a folder has one writer") {
    const ScratchFolder scratch;
    write_atomically(scratch / "f", "text");
    CHECK(contents(scratch / "f") == "text");
    for (const auto& entry : std::filesystem::directory_iterator(scratch / "")) {
        CHECK(entry.path().filename() == "f");
    }
    CHECK_THROWS_AS(write_atomically(scratch / "no" / "f", "text"), FileError);
    CHECK_THROWS_AS(LineAppender("/dev/full").append("line"), FileError);
    const FolderLock shard(scratch / "", "1-of-2");
    CHECK_NOTHROW(FolderLock(scratch / "", "2-of-2"));
    CHECK_THROWS_AS(FolderLock(scratch / "", "1-of-2"), FileError);
    CHECK_THROWS_AS(FolderLock(scratch / "", ""), FileError);
}
