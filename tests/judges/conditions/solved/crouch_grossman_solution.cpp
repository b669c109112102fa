// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/conditions/solved/crouch_grossman_solution.hpp"

#include <Eigen/QR>
#include <stdexcept>

namespace kreisel::orders {

namespace {

constexpr int written_decimals = 44;

/// A method whose coefficients from the index `first` on are unknown, but for those that are zero.
struct CrouchGrossmanUnknowns {
    Vector100 all;
    Eigen::Index first;
    std::size_t stages;
    int order;

    std::vector<Eigen::Index> indices() const {
        std::vector<Eigen::Index> found;
        for (Eigen::Index i = first; i < all.size(); ++i)
            if (all[i] != 0) found.push_back(i);
        return found;
    }
};

Float100 largest_entry(const Vector100& x) { return x.cwiseAbs().maxCoeff(); }

/// Where a method is as special as those printed, its conditions depend on each other to first order, to the 16 digits
/// of the start: directions that small are left out.
Vector100 least_norm_solution(const Matrix100& jacobian, const Vector100& residual) {
    Eigen::CompleteOrthogonalDecomposition<Matrix100> decomposition;
    decomposition.setThreshold(Float100("1e-10"));
    decomposition.compute(jacobian);
    return decomposition.solve(residual);
}

void solve_in_place(CrouchGrossmanUnknowns& x) {
    const std::vector<Eigen::Index> free = x.indices();
    for (int iteration = 0; iteration < 12; ++iteration) {
        const Vector100 residual = conditions(x.all, x.stages, x.order);
        if (largest_entry(residual) < Float100("1e-80")) return;
        const Matrix100 jacobian = conditions_jacobian(x.all, x.stages, x.order)(Eigen::all, free);
        x.all(free) -= least_norm_solution(jacobian, residual);
    }
    throw std::runtime_error("no convergence to order " + std::to_string(x.order));
}

/// What is written in a tableau.
void round_in_place(Vector100& x) {
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = Float100(x[i].str(written_decimals, std::ios_base::fixed));
}

std::vector<Float100> read(const PrintedRow& row) { return {row.begin(), row.end()}; }

}  // namespace

CrouchGrossmanSolution solve(const PublishedCrouchGrossman& published) {
    const std::size_t stages = published.b.size();
    NumericTableau<Float100> tableau;
    for (const PrintedRow& row : published.a) tableau.a.push_back(read(row));
    tableau.b = read(published.b);
    const Vector100 printed = unknowns(tableau);
    CrouchGrossmanUnknowns method{printed, 0, stages, published.order};
    solve_in_place(method);

    // With coefficients that are not rounded yet: conditions that depend on each other contradict each other otherwise.
    NumericTableau<Float100> other{.a = tableau_of(method.all, stages).a, .b = read(published.b_hat)};
    other.a.push_back(read(published.last_row));
    const Eigen::Index held = printed.size() - static_cast<Eigen::Index>(stages);  // the rows of a
    CrouchGrossmanUnknowns embedded{unknowns(other), held, stages + 1, published.order - 1};
    solve_in_place(embedded);

    round_in_place(method.all);
    round_in_place(embedded.all);
    other = tableau_of(embedded.all, stages + 1);
    NumericTableau<Float100> solved{.a = other.a, .b = tableau_of(method.all, stages).b, .b_hat = other.b};
    solved.b.emplace_back(0);
    return {.tableau = solved,
            .moved = largest_entry(method.all - printed),
            .residual = std::max(largest_entry(conditions(method.all, stages, published.order)),
                                 largest_entry(conditions(embedded.all, stages + 1, published.order - 1)))};
}

}  // namespace kreisel::orders
