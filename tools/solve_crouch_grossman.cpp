// SPDX-License-Identifier: BSD-3-Clause
//
// Solves the 13 conditions of order 4 for the 15 coefficients of the five-stage Crouch-Grossman method CG4a, by
// Newton's method with minimum-norm corrections from the printed 16-digit table, in arithmetic of 100 digits; prints
// the rows of `a` and then b with 44 decimals. Run it by tools/solve-crouch-grossman.
#include <Eigen/LU>
#include <iostream>
#include <stdexcept>

#include "tests/judges/conditions/crouch_grossman_system.hpp"
#include "tests/judges/conditions/published_cg4a.hpp"

namespace {

using namespace kreisel::orders;

constexpr std::size_t stages = 5;
constexpr int order = 4, decimals = 44;

Vector100 read(const PrintedTableau& printed) {
    NumericTableau<Float100> tableau;
    for (const auto& row : printed.a) tableau.a.emplace_back(row.begin(), row.end());
    tableau.b = std::vector<Float100>(printed.b.begin(), printed.b.end());
    return unknowns(tableau);
}

Float100 largest(const Vector100& x) { return x.cwiseAbs().maxCoeff(); }

/// Printed with `decimals` decimals and read back: the value in a tableau.
Vector100 rounded(const Vector100& x) {
    Vector100 y(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) y[i] = Float100(x[i].str(decimals, std::ios_base::fixed));
    return y;
}

/// Throws if Newton's method does not get below 1e-90.
Vector100 solve(Vector100 x) {
    for (int iteration = 0; iteration < 12; ++iteration) {
        const Vector100 residual = conditions(x, stages, order);
        std::cerr << "iteration " << iteration << ": largest residual " << largest(residual).str(3) << '\n';
        if (largest(residual) < Float100("1e-90")) return x;
        const Matrix100 J = conditions_jacobian(x, stages, order);
        const Matrix100 normal = J * J.transpose();
        x -= J.transpose() * normal.fullPivLu().solve(residual);
    }
    throw std::runtime_error("no convergence");
}

void print(const Vector100& x) {
    const auto tableau = tableau_of(x, stages);
    const auto print_row = [](const std::vector<Float100>& row) {
        for (const auto& entry : row) std::cout << "\"" << entry.str(decimals, std::ios_base::fixed) << "\"\n";
        std::cout << '\n';
    };
    for (const auto& row : tableau.a) print_row(row);
    print_row(tableau.b);
}

}  // namespace

int main() try {
    const Vector100 start = read(published_cg4a()), solution = rounded(solve(start));
    std::cerr << "largest change of a printed coefficient: " << largest(solution - start).str(3) << '\n'
              << "largest residual of what is printed here: " << largest(conditions(solution, stages, order)).str(3)
              << '\n';
    print(solution);
} catch (const std::exception& error) {
    std::cerr << "solve_crouch_grossman: " << error.what() << '\n';
    return 1;
}
