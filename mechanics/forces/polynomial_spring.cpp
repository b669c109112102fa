// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/forces/polynomial_spring.hpp"

#include "mechanics/forces/entry.hpp"
#include "mechanics/forces/forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Real PolynomialSpring::elastic_tension(const Real& s) const {
    Real sum = 0;
    for (std::size_t i = coefficients.size(); i-- > 0;) sum = (sum + coefficients[i]) * s;
    return sum;
}

Real PolynomialSpring::potential(const Real& s) const {
    Real sum = 0;
    for (std::size_t i = coefficients.size(); i-- > 0;) sum = (sum + coefficients[i] / Real(i + 2)) * s;
    return sum * s;
}

namespace {

void read_polynomial_spring(const ForceEntry& entry, Forces& forces) {
    if (entry.distance == 0)
        entry.refuse("points", "expected two different points, since the force acts along their line");
    PolynomialSpring spring;
    spring.first = entry.first, spring.second = entry.second;
    spring.r_first = entry.r_first, spring.r_second = entry.r_second;
    spring.coefficients = entry.coefficients;
    spring.damping = entry.damping, spring.length = entry.rest.value_or(entry.distance);
    forces.polynomial_springs.push_back(std::move(spring));
}

}  // namespace

KREISEL_FORCE(PolynomialSpring::type, read_polynomial_spring);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
