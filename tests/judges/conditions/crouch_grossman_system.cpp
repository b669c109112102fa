// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/conditions/crouch_grossman_system.hpp"

namespace kreisel::orders {

Vector100 unknowns(const NumericTableau<Float100>& tableau) {
    std::vector<Float100> flat;
    for (const auto& row : tableau.a) flat.insert(flat.end(), row.begin(), row.end());
    flat.insert(flat.end(), tableau.b.begin(), tableau.b.end());
    return Eigen::Map<const Vector100>(flat.data(), static_cast<Eigen::Index>(flat.size()));
}

NumericTableau<Float100> tableau_of(const Vector100& unknowns, std::size_t stages) {
    NumericTableau<Float100> tableau;
    const Float100* next = unknowns.data();
    for (std::size_t i = 0; i < stages; next += i++) tableau.a.emplace_back(next, next + i);
    tableau.b.assign(next, next + stages);
    return tableau;
}

Vector100 conditions(const Vector100& unknowns, std::size_t stages, int order) {
    const auto tableau = tableau_of(unknowns, stages);
    std::vector<Float100> all;
    for (int p = 1; p <= order; ++p)
        for (const auto& residual : conditions_of_order(tableau, p)) all.push_back(residual);
    return Eigen::Map<const Vector100>(all.data(), static_cast<Eigen::Index>(all.size()));
}

Matrix100 conditions_jacobian(const Vector100& unknowns, std::size_t stages, int order) {
    const Float100 width("1e-50");
    const Vector100 here = conditions(unknowns, stages, order);
    Matrix100 jacobian(here.size(), unknowns.size());
    for (Eigen::Index j = 0; j < unknowns.size(); ++j) {
        Vector100 shifted = unknowns;
        shifted[j] += width;
        jacobian.col(j) = (conditions(shifted, stages, order) - here) / width;
    }
    return jacobian;
}

}  // namespace kreisel::orders
