// SPDX-License-Identifier: BSD-3-Clause
//
// The contents of the page, in each of the three formats: every entry of a legend and every label, within the page and
// apart from each other. Text is read from SVG with its place, from PDF by pdftotext; of a PNG only the size is
// checked, which is that of the page all three share.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <regex>

#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/gnuplot.hpp"
#include "plots/figures/panels.hpp"
#include "plots/plot.hpp"
#include "support/files.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

constexpr double pixels_per_cm = 37.8;  // of SVG, see plots/gnuplot/terminal.gp

constexpr double letters_apart = 12;  // pixels from line to line, of letters of 10

struct PlacedText {
    double x, y;
    bool upright;
    std::string text;
};

// All texts of an SVG file, in pixels from the upper left corner.
std::vector<PlacedText> texts_of(const std::string& svg) {
    static const std::regex piece(
        R"re(translate\(([-0-9.]+),([-0-9.]+)\)( rotate\([-0-9.]+\))?"[^>]*>\s*<text>(.*?)</text>)re");
    static const std::regex tag("<[^>]*>");
    std::vector<PlacedText> all;
    for (auto it = std::sregex_iterator(svg.begin(), svg.end(), piece); it != std::sregex_iterator(); ++it) {
        all.push_back({std::stod((*it)[1]), std::stod((*it)[2]), (*it)[3].length() == 0,
                       std::regex_replace((*it)[4].str(), tag, "")});
    }
    return all;
}

double attribute(const std::string& svg, const std::string& name) {
    const auto at = svg.find(name + "=\"");
    return std::stod(svg.substr(at + name.size() + 2));
}

// The objection to an SVG file that should show each of the texts `times` times; empty if there is none.
std::string fault(const std::string& svg, const std::vector<std::string>& texts, std::size_t times) {
    const double width = attribute(svg, "width"), height = attribute(svg, "height");
    std::vector<PlacedText> found;
    for (const std::string& text : texts) {
        std::size_t count = 0;
        for (const PlacedText& placed : texts_of(svg)) {
            if (placed.text != text) { continue; }
            ++count;
            const double length = 0.13 * pixels_per_cm * static_cast<double>(enhanced_width(text)), half = 5;
            const bool inside =
                placed.upright
                    ? placed.x > 0 && placed.x + length < width && placed.y > half && placed.y + half < height
                    : placed.x > 2 * half && placed.x < width && placed.y > 0 && placed.y < height;
            if (!inside) { return text + ": beyond the page"; }
            for (const PlacedText& other : found) {
                if (std::abs(other.x - placed.x) < 1 && std::abs(other.y - placed.y) < 2 * half) {
                    return text + ": on top of " + other.text;
                }
            }
            found.push_back(placed);
        }
        if (count != times) { return text + ": " + std::to_string(count) + " times"; }
    }
    return "";
}

// From a label of an x axis up to the labels of its tics, pixels.
double space_above(const std::string& svg, const std::string& label) {
    const std::vector<PlacedText> all = texts_of(svg);
    const auto placed = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.text == label; });
    double least = attribute(svg, "height");
    for (const PlacedText& other : all) {
        if (other.y < placed->y) { least = std::min(least, placed->y - other.y); }
    }
    return least;
}

std::string pdf_text(const std::filesystem::path& file) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(
        ::popen(("pdftotext -layout '" + file.string() + "' -").c_str(), "r"), ::pclose);
    std::string text;
    char buffer[4096];
    while (const std::size_t length = std::fread(buffer, 1, sizeof buffer, pipe.get())) { text.append(buffer, length); }
    return text;
}

std::size_t count_of(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) { ++count; }
    return count;
}

// Width and height in the header of a PNG.
std::pair<long, long> size_of(const std::string& png) {
    const auto number = [&](std::size_t at) {
        long value = 0;
        for (std::size_t i = at; i < at + 4; ++i) { value = 256 * value + static_cast<unsigned char>(png.at(i)); }
        return value;
    };
    return {number(16), number(20)};
}

// Panels beside each other with the same curves, none of whose names begins another.
PanelFigure figure_of(std::size_t panels, std::size_t curves) {
    PanelFigure figure{"page", "A title", {}};
    for (std::size_t p = 0; p < panels; ++p) {
        Panel panel{"", "the step h [s]", "the error [m]", true, true, {}, {}, {}};
        for (std::size_t i = 0; i < curves; ++i) {
            const double x = 0.5 / static_cast<double>(i + 1);
            panel.curves.push_back({"method " + std::to_string(100 + i) + ": 4.00 ± 0.01",
                                    {{1e-3, x * 1e-9}, {1e-1, x}},
                                    static_cast<int>(i + 1)});
        }
        figure.panels.push_back(std::move(panel));
    }
    return figure;
}

std::vector<std::string> legend_of(const PanelFigure& figure) {
    std::vector<std::string> labels;
    for (const Curve& curve : figure.panels.front().curves) { labels.push_back(curve.label); }
    return labels;
}

}  // namespace

TEST_CASE("every legend entry and label is on the page in all three formats") {
    const auto scripts = plot_scripts();
    for (const auto& [panels, curves] :
         {std::pair<std::size_t, std::size_t>{1, 20}, {2, 20}, {2, 3}, {3, 45}, {1, 1}}) {
        CAPTURE(panels, curves);
        const ResultFolder folder;
        make_folder(folder.path() / "figures");
        const PanelFigure figure = figure_of(panels, curves);
        write_panels(folder.path() / "plotdata", figure);
        REQUIRE(run_gnuplot(folder.path(), scripts, "linespoints", figure.name).empty());
        const std::string svg = folder.read("figures/page.svg");
        std::vector<std::string> texts = legend_of(figure);
        texts.insert(texts.end(), {figure.panels[0].x_label, figure.panels[0].y_label});
        CHECK(fault(svg, texts, panels) == "");
        CHECK(fault(svg, {figure.title}, 1) == "");
        CHECK(space_above(svg, figure.panels[0].x_label) > letters_apart);
        const std::string pdf = pdf_text(folder.path() / "figures" / "page.pdf");
        for (const std::string& label : legend_of(figure)) { CHECK(count_of(pdf, label) == panels); }
        CHECK(count_of(pdf, figure.panels[0].x_label) == panels);
        CHECK(count_of(pdf, figure.title) == 1);
        const auto [width, height] = size_of(folder.read("figures/page.png"));
        CHECK(std::abs(static_cast<double>(width) / 80 - attribute(svg, "width") / pixels_per_cm) < 0.05);
        CHECK(std::abs(static_cast<double>(height) / 80 - attribute(svg, "height") / pixels_per_cm) < 0.05);
    }
}

TEST_CASE("control: a lost entry, one beyond the page and two in one place are seen") {
    const ResultFolder folder;
    make_folder(folder.path() / "figures");
    const PanelFigure figure = figure_of(2, 6);
    write_panels(folder.path() / "plotdata", figure);
    run_gnuplot(folder.path(), plot_scripts(), "linespoints", figure.name);
    const std::string svg = folder.read("figures/page.svg");
    const auto labels = legend_of(figure);
    REQUIRE(fault(svg, labels, 2) == "");
    std::string touching = svg;
    const auto label = touching.find(figure.panels[0].x_label), at = touching.rfind("translate(", label);
    const auto comma = touching.find(',', at);
    const double y = std::stod(touching.substr(comma + 1));
    touching.replace(comma + 1, touching.find(')', comma) - comma - 1, std::to_string(y - 5));
    CHECK(space_above(touching, figure.panels[0].x_label) < letters_apart);
    std::string lost = svg;
    lost.replace(lost.find(labels[2]), 6, "nobody");
    CHECK(fault(lost, labels, 2) == labels[2] + ": 1 times");
    std::string low = svg;
    low.replace(low.find("height=\"") + 8, 3, "150");
    CHECK(fault(low, labels, 2) == labels[0] + ": beyond the page");
    std::string narrow = svg;
    narrow.replace(narrow.find("width=\"") + 7, 3, "400");
    CHECK(fault(narrow, labels, 2) == labels[0] + ": beyond the page");
    std::string twice = svg;
    twice.replace(twice.find(labels[2]), labels[2].size(), labels[1]);
    CHECK(fault(twice + svg, {labels[1]}, 5) == labels[1] + ": on top of " + labels[1]);
}

TEST_CASE("of a short logarithmic axis twos and fives are labelled, too, where they find space") {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(4));  // h over a decade and a half
    const auto is_labelled = [&](int width) {
        folder.manifest({{"name", "f"},
                         {"kind", "convergence"},
                         {"figure", {{"kind", "convergence"}, {"name", "f"}, {"width", width}}}});
        REQUIRE(plot_command({.folders = {folder.path()}, .figure = {}, .output = {}}) == Exit::ok);
        const std::vector<PlacedText> texts = texts_of(folder.read("figures/f.svg"));
        return std::any_of(texts.begin(), texts.end(), [](const auto& one) { return one.text == "2·10−3"; });
    };
    CHECK(is_labelled(120));
    CHECK_FALSE(is_labelled(85));
}

TEST_CASE("dashed curves are drawn over solid ones, in the order of the legend otherwise") {
    const ResultFolder folder;
    make_folder(folder.path() / "figures");
    PanelFigure figure = figure_of(1, 4);
    const std::vector<int> styles = {2, 1, 3, 6};  // 1 and 6 are solid
    for (std::size_t i = 0; i < styles.size(); ++i) { figure.panels[0].curves[i].style = styles[i]; }
    write_panels(folder.path() / "plotdata", figure);
    REQUIRE(run_gnuplot(folder.path(), plot_scripts(), "lines", figure.name).empty());
    const std::string svg = folder.read("figures/page.svg");
    static const std::regex stroke(R"(id="gnuplot_plot_\d+a"[\s\S]*?<path stroke='([^']*)')");
    std::vector<std::string> colours;
    for (auto it = std::sregex_iterator(svg.begin(), svg.end(), stroke); it != std::sregex_iterator(); ++it) {
        colours.push_back(std::regex_replace((*it)[1].str(), std::regex(" "), ""));
    }
    CHECK(colours == std::vector<std::string>{"rgb(0,114,178)", "rgb(86,180,233)", "rgb(213,94,0)", "rgb(0,158,115)"});
}
