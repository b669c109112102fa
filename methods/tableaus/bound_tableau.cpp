// SPDX-License-Identifier: BSD-3-Clause
#include "methods/tableaus/bound_tableau.hpp"

#include <stdexcept>

namespace kreisel {
inline namespace KREISEL_PRECISION {

Real value(const Coefficient& c) { return c.digits ? from_text(c.digits) : Real(c.numerator) / Real(c.denominator); }

namespace {

Combination nonzero(const std::vector<Coefficient>& row, std::size_t stride) {
    Combination terms;
    for (std::size_t j = 0; j < row.size(); ++j)
        if (!row[j].is_zero()) terms.push_back({value(row[j]), j * stride});
    return terms;
}

Real sum(const Combination& terms) {
    Real total = 0;
    for (const Term& term : terms) total += term.coefficient;
    return total;
}

}  // namespace

BoundTableau::BoundTableau(const Tableau& tableau, std::size_t stride) : b(nonzero(tableau.b, stride)) {
    if (tableau.a.size() != tableau.b.size())
        throw std::invalid_argument("tableau with " + std::to_string(tableau.a.size()) + " rows and " +
                                    std::to_string(tableau.b.size()) + " weights");
    for (std::size_t i = 0; i < tableau.a.size(); ++i) {
        if (tableau.a[i].size() > i)
            throw std::invalid_argument("row " + std::to_string(i + 1) + " of an explicit tableau has " +
                                        std::to_string(tableau.a[i].size()) + " entries, more than " +
                                        std::to_string(i));
        a.push_back(nonzero(tableau.a[i], stride));
        c.push_back(sum(a.back()));
    }
    if (abs(sum(b) - 1) > 64 * epsilon) throw std::invalid_argument("the weights of the tableau do not sum to 1");
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
