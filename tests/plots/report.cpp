// SPDX-License-Identifier: BSD-3-Clause
//
// The page of a report as text: what stands in it, and how. tests/browser/ uses it.
#include <catch2/catch.hpp>
#include <regex>

#include "plots/report/cells.hpp"
#include "plots/report/figures.hpp"
#include "plots/report/page.hpp"
#include "plots/report/report.hpp"
#include "records/reading/read_results.hpp"
#include "support/base64.hpp"
#include "support/sha256.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

const std::string evil_label = "</script><script>alert(1)</script><!--";

std::string text_between(const std::string& text, const std::string& from, const std::string& to) {
    const auto start = text.find(from);
    REQUIRE(start != std::string::npos);
    const auto end = text.find(to, start + from.size());
    REQUIRE(end != std::string::npos);
    return text.substr(start + from.size(), end - start - from.size());
}

// What the script of a page reads.
nlohmann::json data_of(const std::string& page) {
    return nlohmann::json::parse(text_between(page, R"(id="data">)", "</script>"));
}

struct ReportedFolder : ResultFolder {
    explicit ReportedFolder(const nlohmann::json& changes = {}) {
        write("results.jsonl", convergence_lines(4, changes));
        manifest({{"name", "top"}, {"kind", "convergence"}, {"problems", {"heavy_top"}}});
    }
    nlohmann::json report(Exit expected = Exit::ok) const {
        CHECK(report_command(path(), path() / "page.html") == expected);
        return data_of(read("page.html"));
    }
};

// The numbers of a column, as the page holds them.
nlohmann::json column_named(const nlohmann::json& table, const std::string& title) {
    for (const auto& column : table.at("columns")) {
        if (column.at("title") == title) { return column; }
    }
    return nullptr;
}

}  // namespace

TEST_CASE("base64 and SHA-256 are those of their standards") {
    for (const auto& [bytes, text] : {std::pair<std::string, std::string>{"", ""},
                                      {"f", "Zg=="},
                                      {"fo", "Zm8="},
                                      {"foobar", "Zm9vYmFy"},
                                      {std::string("\0\xff", 2), "AP8="}}) {
        CHECK(base64_text(bytes) == text);
    }
    CHECK(base64_text(sha256_bytes("abc")) == "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
}

TEST_CASE("a page allows its own script by its sum, and nothing else") {
    const std::string page = report_page("A & B <C>", "{}");
    const std::string policy = text_between(page, R"(<meta http-equiv="Content-Security-Policy" content=")", "\"");
    const std::string script = text_between(page, "<script>", "</script>");
    CHECK(script.size() > 10000);
    CHECK(policy == "default-src 'none'; script-src 'sha256-" + base64_text(sha256_bytes(script)) +
                        "'; style-src 'unsafe-inline'; img-src data: blob:");
    CHECK(page.find("<title>A &amp; B &lt;C&gt;</title>") != std::string::npos);
    CHECK(page.find("<meta http-equiv") < page.find("<style"));
    CHECK_FALSE(std::regex_search(page, std::regex(R"re((src|href)\s*=\s*["']?(https?:|//))re")));
}

TEST_CASE("labels with markup are data of the page and no markup of it") {
    const ReportedFolder folder(nlohmann::json{{"label", evil_label}});
    const nlohmann::json data = folder.report();
    CHECK(folder.read("page.html").find("<script>alert") == std::string::npos);
    CHECK(text_between(folder.read("page.html"), R"(id="data">)", "</script>").find('<') == std::string::npos);
    CHECK(column_named(data.at("tables").at(0), "problem").at("same") == evil_label);
}

TEST_CASE("a page holds every cell with its numbers as they are, and the curves of the figures") {
    const ReportedFolder folder;
    const nlohmann::json data = folder.report();
    const nlohmann::json& cells = data.at("tables").at(0);
    CHECK(cells.at("rows") == 6);
    CHECK(column_named(cells, "h [s]").at("numbers").at(0) == 1.0 / 64);
    CHECK(column_named(cells, "error.position [m]").at("numbers").at(5) == std::pow(1.0 / 2048, 4));
    CHECK(column_named(cells, "method").at("same") == "rkmk/rk4");
    const Results results = read_results(folder.path());
    const PanelFigure drawn = panels_of({{"kind", "convergence"}}, results);
    const nlohmann::json& curve = data.at("figures").at(0).at("panels").at(0).at("curves").at(0);
    REQUIRE(drawn.panels.at(0).curves.at(0).points.size() == curve.at("x").size());
    for (std::size_t i = 0; i < curve.at("x").size(); ++i) {
        CHECK(curve.at("x").at(i) == drawn.panels[0].curves[0].points[i].x);
        CHECK(curve.at("y").at(i) == drawn.panels[0].curves[0].points[i].y);
    }
    CHECK(curve.at("fitted").size() >= 4);
    CHECK(curve.at("label").get<std::string>().find("4.00") != std::string::npos);
}

TEST_CASE("a curve with the x of an earlier one names it") {
    Panel panel;
    panel.curves.resize(3);
    panel.curves[0].points = {{1, 2}, {3, 4}};
    panel.curves[1].points = {{1, 2}, {4, 4}};
    panel.curves[2].points = {{1, 5}, {3, 6}};
    const nlohmann::json curves = nlohmann::json::parse(json_value(panel)).at("curves");
    CHECK(curves.at(0).at("x") == nlohmann::json{1, 3});
    CHECK(curves.at(1).at("x") == nlohmann::json{1, 4});
    CHECK(curves.at(2).at("x") == 0);
    CHECK(curves.at(2).at("y") == nlohmann::json{5, 6});
}

TEST_CASE("quad numbers keep their digits on the page") {
    const std::string digits = "3.611600096117610758135889554237184097e-33";
    const ReportedFolder folder(nlohmann::json{{"precision", "quad"}, {"metrics", {{"error.position", digits}}}});
    const nlohmann::json data = folder.report();
    CHECK(column_named(data.at("tables").at(0), "error.position [m]").at("same") == digits);
}

TEST_CASE("what failed, is missing or damaged is said on the page") {
    const ReportedFolder folder(nlohmann::json{{"status", "left_chart"}, {"detail", "in step 3"}, {"t_reached", 0.5}});
    nlohmann::json data = folder.report();
    CHECK(data.at("wanting") == "6 of 6 cells failed");
    CHECK(column_named(data.at("tables").at(0), "reason").at("same") == "in step 3");
    folder.write("results.jsonl", convergence_lines(4) + "{\"cell\": 1\n");
    data = folder.report(Exit::io);
    CHECK(data.at("damage").at(0).get<std::string>().find("results.jsonl:7") != std::string::npos);
    CHECK(data.at("wanting") == "damaged results are left out");
    const ReportedFolder none(nlohmann::json{{"metrics", {{"error.position", nullptr}}}});
    data = none.report(Exit::cells_failed);
    CHECK(data.at("figures").at(0).contains("not_drawn"));
}

TEST_CASE("the page in the folder is a derived file: summed, and never written over another one") {
    const ReportedFolder folder;
    CHECK(report_command(folder.path(), {}) == Exit::ok);
    CHECK(folder.has("report.html"));
    CHECK(folder.read("sums.sha256").find("  report.html\n") != std::string::npos);
}

TEST_CASE("columns say once what is the same, keep texts apart and numbers exact") {
    ColumnTable table{"t",
                      "T",
                      {{"same", {"a", "a"}, true},
                       {"number", {"1e-05", ""}},
                       {"text", {"12", "12"}, true},
                       {"words", {"x", "1"}},
                       {"not JSON", {"01", "5."}}}};
    const auto json = nlohmann::json::parse(json_value(table));
    CHECK(json.at("rows") == 2);
    CHECK(json.at("columns").at(0).at("same") == "a");
    CHECK(json.at("columns").at(1).at("numbers") == nlohmann::json({1e-05, nullptr}));
    CHECK(json.at("columns").at(2).at("same") == "12");
    CHECK(json.at("columns").at(3).at("texts") == nlohmann::json({"x", "1"}));
    CHECK(json.at("columns").at(4).at("index") == nlohmann::json({0, 1}));
}
