// SPDX-License-Identifier: BSD-3-Clause
#include "methods/conditions/written_tableau.hpp"

#include <sstream>

#include "methods/conditions/exact_text.hpp"

namespace kreisel::orders {

namespace {

const std::string& text_of(const OptionValues& options, const std::string& name) {
    return std::get<std::string>(options.at(name));
}

/// Appends the numbers of one row to both.
void read_row(const std::string& row, WrittenTableau& written, std::vector<Coefficient>& coefficients,
              std::vector<Rational>& numbers) {
    std::istringstream words(row);
    for (std::string word; words >> word;) {
        numbers.push_back(read_exact(word));
        coefficients.push_back(read_coefficient(word, written.digits));
        written.rounded = written.rounded || is_rounded(word);
    }
}

std::string in_row(std::size_t row) { return " in row " + std::to_string(row); }

std::string entries(std::size_t count) { return std::to_string(count) + (count == 1 ? " entry" : " entries"); }

/// Row i, from 1, has i - 1 entries. The first may be left out.
void read_rows(const std::string& text, WrittenTableau& written) {
    std::istringstream rows(text);
    for (std::string row; std::getline(rows, row, ';');) {
        if (written.tableau.a.empty() && row.find_first_not_of(' ') != std::string::npos) {
            written.tableau.a.emplace_back();
            written.exact.a.emplace_back();
        }
        const std::size_t number = written.tableau.a.size() + 1;
        auto& coefficients = written.tableau.a.emplace_back();
        try {
            read_row(row, written, coefficients, written.exact.a.emplace_back());
        } catch (const std::invalid_argument& error) { throw OptionError("a", error.what() + in_row(number)); }
        if (coefficients.size() + 1 != number)
            throw OptionError("a", "expected " + entries(number - 1) + in_row(number) +
                                       ", those before the diagonal, got " + std::to_string(coefficients.size()));
    }
    if (written.tableau.a.empty()) written.tableau.a.emplace_back(), written.exact.a.emplace_back();
}

/// As many as `stages`; none where the text is empty and they are not `required`.
void read_weights(const OptionValues& options, const std::string& name, bool required, WrittenTableau& written,
                  std::vector<Coefficient>& coefficients, std::vector<Rational>& numbers) {
    try {
        read_row(text_of(options, name), written, coefficients, numbers);
    } catch (const std::invalid_argument& error) { throw OptionError(name, error.what()); }
    const std::size_t stages = written.tableau.a.size();
    if (coefficients.size() == stages || (coefficients.empty() && !required)) return;
    throw OptionError(
        name, "expected " + entries(stages) + ", one for each row of a, got " + std::to_string(coefficients.size()));
}

}  // namespace

WrittenTableau read_tableau(const OptionValues& options) {
    WrittenTableau written;
    read_rows(text_of(options, "a"), written);
    read_weights(options, "b", true, written, written.tableau.b, written.exact.b);
    read_weights(options, "b_hat", false, written, written.tableau.b_hat, written.exact.b_hat);
    read_weights(options, "c", false, written, written.tableau.c, written.nodes);
    return written;
}

}  // namespace kreisel::orders
