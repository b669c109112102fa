// SPDX-License-Identifier: BSD-3-Clause
#include "methods/bound_tableau.hpp"

#include <stdexcept>

namespace kreisel {
inline namespace KREISEL_PRECISION {

Real value(const Coefficient& c) { return c.digits ? from_text(c.digits) : Real(c.numerator) / Real(c.denominator); }

namespace {

Combination nonzero(const std::vector<Coefficient>& row) {
    Combination terms;
    for (std::size_t j = 0; j < row.size(); ++j)
        if (!row[j].is_zero()) terms.push_back({value(row[j]), static_cast<int>(j)});
    return terms;
}

Real sum(const Combination& terms) {
    Real total = 0;
    for (const Term& term : terms) total += term.coefficient;
    return total;
}

}  // namespace

BoundTableau::BoundTableau(const Tableau& tableau) : b(nonzero(tableau.b)) {
    if (tableau.a.size() != tableau.b.size())
        throw std::invalid_argument("tableau with " + std::to_string(tableau.a.size()) + " rows and " +
                                    std::to_string(tableau.b.size()) + " weights");
    for (std::size_t i = 0; i < tableau.a.size(); ++i) {
        if (tableau.a[i].size() > i)
            throw std::invalid_argument("row " + std::to_string(i + 1) + " of an explicit tableau has " +
                                        std::to_string(tableau.a[i].size()) + " entries, more than " + std::to_string(i));
        a.push_back(nonzero(tableau.a[i]));
        c.push_back(sum(a.back()));
    }
    if (abs(sum(b) - 1) > 64 * epsilon) throw std::invalid_argument("the weights of the tableau do not sum to 1");
}

void combine(const Combination& terms, const Real& h, const Real* slopes, int n, Real* out) {
    const auto slope = [&](std::size_t j) { return slopes + terms[j].stage * n; };
    const auto weight = [&](std::size_t j) { return h * terms[j].coefficient; };
    std::size_t done = 0;
    if (terms.size() >= 4) {
        const Real w0 = weight(0), w1 = weight(1), w2 = weight(2), w3 = weight(3);
        const Real *k0 = slope(0), *k1 = slope(1), *k2 = slope(2), *k3 = slope(3);
        for (int i = 0; i < n; ++i) out[i] = w0 * k0[i] + w1 * k1[i] + w2 * k2[i] + w3 * k3[i];
        done = 4;
    } else if (terms.size() >= 2) {
        const Real w0 = weight(0), w1 = weight(1);
        const Real *k0 = slope(0), *k1 = slope(1);
        for (int i = 0; i < n; ++i) out[i] = w0 * k0[i] + w1 * k1[i];
        done = 2;
    } else if (terms.size() == 1) {
        const Real w0 = weight(0);
        const Real* k0 = slope(0);
        for (int i = 0; i < n; ++i) out[i] = w0 * k0[i];
        done = 1;
    } else {
        for (int i = 0; i < n; ++i) out[i] = 0;
    }
    for (; done < terms.size(); ++done) {
        const Real w = weight(done);
        const Real* k = slope(done);
        for (int i = 0; i < n; ++i) out[i] += w * k[i];
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
