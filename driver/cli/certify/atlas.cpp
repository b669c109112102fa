// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/certify/atlas.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <regex>

#include "driver/cli/catalogue/methods.hpp"
#include "plots/tables/latex.hpp"
#include "plots/tables/table.hpp"
#include "records/reading/read_results.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

constexpr std::size_t most_coefficients = 45;  // of a tableau that is printed: those with nine stages

// The tables `certification` of a study, one for each problem.
struct ObservedOrders {
    std::string problem;
    TextTable table;
};

std::vector<ObservedOrders> observed_in(const Paths& folders) {
    const auto& tables = result_tables();
    const auto certification = std::find_if(tables.begin(), tables.end(),
                                            [](const ResultTable& table) { return table.name == "certification"; });
    std::vector<ObservedOrders> all;
    for (const std::filesystem::path& folder : folders) {
        const Results results = read_results(folder);
        if (!certification->applies(results)) { continue; }
        const std::string precision = results.rows.front().precision;
        for (TablePair& pair : certification->make(results)) {
            const std::string label = pair.full.title.substr(pair.full.title.rfind(": ") + 2);
            all.push_back({label + (precision == "double" ? "" : ", " + precision), std::move(pair.full)});
        }
    }
    return all;
}

// Cells of a formulation that a study lacks, and those that were skipped, are dashes.
TextTable orders_of(const std::string& method, const std::vector<ObservedOrders>& studies) {
    TextTable table{"orders", "Observed orders", {"problem"}, {}};
    const std::size_t first = 2;  // behind method and declared order
    for (const ObservedOrders& study : studies) {
        const auto& rows = study.table.rows;
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one[0] == method; });
        if (row == rows.end()) { continue; }
        std::vector<std::string> line = {study.problem};
        line.resize(table.columns.size(), "-");
        for (std::size_t c = first; c < row->size(); ++c) {
            const std::string& formulation = study.table.columns[c];
            const auto at = std::find(table.columns.begin(), table.columns.end(), formulation) - table.columns.begin();
            if (at == static_cast<std::ptrdiff_t>(table.columns.size())) { table.columns.push_back(formulation); }
            line.resize(table.columns.size(), "-");
            line[static_cast<std::size_t>(at)] = (*row)[c];
        }
        table.rows.push_back(line);
    }
    for (auto& line : table.rows) { line.resize(table.columns.size(), "-"); }
    return table;
}

std::size_t coefficient_count(const std::vector<SchemeRow>& scheme) {
    std::size_t sum = 0;
    for (const SchemeRow& row : scheme) { sum += row.coefficients.size(); }
    return sum;
}

// "a_3" is a_{3}, "b^" is \hat b, "y_3 = y_1 exp" says exp.
std::string mathematics(const std::string& label) {
    std::string text = std::regex_replace(label, std::regex(R"(_(\d+))"), "_{$1}");
    text = std::regex_replace(text, std::regex(R"((\w)\^)"), "\\hat $1");
    return std::regex_replace(text, std::regex("exp"), "\\exp");
}

// A fraction as it is, of decimals the first digits.
std::string mathematics_of_coefficient(const std::string& text) {
    constexpr std::size_t shown = 10;
    const std::size_t slash = text.find('/');
    if (slash != std::string::npos) {
        const bool negative = text.front() == '-';
        return fmt::format("{}\\tfrac{{{}}}{{{}}}", negative ? "-" : "",
                           text.substr(negative ? 1 : 0, slash - (negative ? 1 : 0)), text.substr(slash + 1));
    }
    return text.size() <= shown ? text : text.substr(0, shown) + "\\dots";
}

std::string latex_of_coefficients(const std::vector<SchemeRow>& scheme) {
    std::string text;
    for (const SchemeRow& row : scheme) {
        std::vector<std::string> all;
        for (const std::string& one : row.coefficients) { all.push_back(mathematics_of_coefficient(one)); }
        const bool is_product = row.label.ends_with("exp");
        if (all.empty() && !is_product) { continue; }  // the first stage
        text += fmt::format("{}${}{}({})$",
                            text.empty()                       ? ""
                            : is_product && row.label == "exp" ? " "
                                                               : ", ",
                            mathematics(row.label), is_product ? "" : "=", fmt::join(all, ",\\,"));
    }
    return text;
}

// "Order 3; ... O(h^3)" as a sentence with mathematics.
std::string latex_of_declaration(const MethodDescription& method) {
    std::string text = latex_escaped(declaration_of(method));
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return std::regex_replace(text, std::regex(R"(O\(h\\textasciicircum\{\}(\d+)\))"), "$$O(h^{$1})$$");
}

std::string latex_sheet(const MethodDescription& method, const std::vector<SchemeRow>& scheme,
                        const TextTable& orders) {
    std::string text =
        fmt::format("\\atlasmethod{{{}}}{{{}}}{{{}}}{{{}}}\n", latex_escaped(method.name),
                    latex_escaped(method.summary), fmt::join(method.cites, ","), latex_of_declaration(method));
    if (!scheme.empty() && coefficient_count(scheme) <= most_coefficients) {
        text += fmt::format("\\atlascoefficients{{{}}}\n", latex_of_coefficients(scheme));
    }
    if (!orders.rows.empty()) { text += fmt::format("\\atlasorders{{%\n{}}}\n", latex_text(orders)); }
    return text;
}

void print_sheet(const MethodDescription& method, const TextTable& orders, std::ostream& out) {
    fmt::print(out, "{}: {}\n", method.name, method.summary);
    print_sources(out, method.cites);
    fmt::print(out, "{}\n{}\n", declaration_of(method), orders.rows.empty() ? "" : terminal_text(orders));
}

}  // namespace

Exit atlas_command(const Paths& folders, const std::filesystem::path& output, const Engines& engines,
                   const Terminal& terminal) {
    const std::vector<ObservedOrders> studies = observed_in(folders);
    std::string latex;
    for (const MethodDescription& method : engines.binary64.methods()) {
        const TextTable orders = orders_of(method.name, studies);
        latex += latex_sheet(method, engines.binary64.scheme(method.name), orders) + "\n";
        if (output.empty()) { print_sheet(method, orders, terminal.out); }
    }
    if (!output.empty()) {
        const auto file = output / "atlas.tex";
        require_own({file}, file, "\\atlasmethod{");
        make_folder(output);
        write_atomically(file, latex);
    }
    return Exit::ok;
}

}  // namespace kreisel
