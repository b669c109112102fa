// SPDX-License-Identifier: BSD-3-Clause
//
// Solves the order conditions of a Crouch-Grossman method whose source prints 16 decimals or closed forms, and those of
// its embedded solution, in arithmetic of 100 digits; prints the rows of a, then b and b^ with 44 decimals. Run it by
// tools/solve-crouch-grossman.
#include <iostream>
#include <stdexcept>

#include "tests/judges/conditions/solved/crouch_grossman_solution.hpp"

namespace {

using namespace kreisel::orders;

PublishedCrouchGrossman named(const std::string& name) {
    if (name == "cg4a") return published_cg4a();
    if (name == "cg5a") return published_cg5a();
    if (name == "cg43") return published_cg43();
    throw std::invalid_argument("no published method \"" + name + "\": cg4a, cg5a or cg43");
}

void print(const std::vector<Float100>& row) {
    for (const Float100& entry : row) std::cout << "\"" << entry.str(44, std::ios_base::fixed) << "\"\n";
    std::cout << '\n';
}

}  // namespace

int main(int count, char** arguments) try {
    if (count != 2) throw std::invalid_argument("usage: solve-crouch-grossman cg4a|cg5a|cg43");
    const CrouchGrossmanSolution solution = solve(named(arguments[1]));
    std::cerr << "largest change of a printed coefficient: " << solution.moved.str(3)
              << "\nlargest residual of what is printed here: " << solution.residual.str(3) << '\n';
    for (const auto& row : solution.tableau.a) print(row);
    print(solution.tableau.b);
    print(solution.tableau.b_hat);
} catch (const std::exception& error) {
    std::cerr << "solve-crouch-grossman: " << error.what() << '\n';
    return 1;
}
