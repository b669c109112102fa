// SPDX-License-Identifier: BSD-3-Clause
//
// Solves the order conditions of a pair for the digits that its source does not print, and prints the rows of `a`, b
// and b^ with 44 decimals. Run it by tools/solve-tableau.
#include <iostream>
#include <stdexcept>

#include "tests/judges/conditions/pair_solution.hpp"

namespace {

using namespace kreisel::orders;

constexpr int decimals = 44;

PublishedPair named(const std::string& name) {
    for (const PublishedPair& pair : {published_tsit5(), published_dop853()})
        if (pair.method == "rkmk/" + name) return pair;
    throw std::invalid_argument("there are tsit5 and dop853, not \"" + name + "\"");
}

void print(const std::vector<Float100>& row) {
    for (const Float100& entry : row)
        std::cout << (entry == 0 ? "0" : "\"" + entry.str(decimals, std::ios_base::fixed) + "\"") << '\n';
    std::cout << '\n';
}

void print(const PairSolution& solution) {
    std::cerr << "held:";
    for (const Entry& entry : solution.held) {
        const char* const names[] = {"c", "a", "b", "b^"};
        std::cerr << ' ' << names[static_cast<int>(entry.of)] << '_' << entry.i;
        if (entry.j > 0) std::cerr << ',' << entry.j;
    }
    std::cerr << "\nlargest change of a coefficient: " << solution.moved.str(3)
              << "\nlargest residual: " << solution.residual.str(3) << '\n';
    for (const auto& row : solution.tableau.a) print(row);
    print(solution.tableau.b);
    print(solution.tableau.b_hat);
}

}  // namespace

int main(int count, char** arguments) try {
    if (count != 2) throw std::invalid_argument("usage: solve-tableau tsit5|dop853");
    print(solve(named(arguments[1])));
} catch (const std::exception& error) {
    std::cerr << "solve-tableau: " << error.what() << '\n';
    return 1;
}
