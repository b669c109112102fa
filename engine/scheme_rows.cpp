// SPDX-License-Identifier: BSD-3-Clause
#include "engine/scheme_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::string text_of(const Coefficient& x) {
    if (x.digits) return x.digits;
    return std::to_string(x.numerator) + (x.denominator == 1 ? "" : "/" + std::to_string(x.denominator));
}

std::vector<std::string> texts_of(const std::vector<Coefficient>& row) {
    std::vector<std::string> all;
    for (const Coefficient& x : row) all.push_back(text_of(x));
    return all;
}

std::vector<SchemeRow> rows_of(const Tableau& tableau) {
    std::vector<SchemeRow> rows;
    for (std::size_t i = 0; i < tableau.a.size(); ++i)
        rows.push_back({"a_" + std::to_string(i + 1), texts_of(tableau.a[i])});
    rows.push_back({"b", texts_of(tableau.b)});
    if (!tableau.b_hat.empty()) rows.push_back({"b^", texts_of(tableau.b_hat)});
    return rows;
}

/// "y_3 = y_1 exp", then "exp" for each further factor.
void add_product(const std::string& name, const ExponentialProduct& product, std::vector<SchemeRow>& rows) {
    std::string label = name + " = y_" + std::to_string(product.from) + " exp";
    for (const auto& factor : product.factors) {
        rows.push_back({label, texts_of(factor)});
        label = "exp";
    }
}

std::vector<SchemeRow> rows_of(const CommutatorFreeScheme& scheme) {
    std::vector<SchemeRow> rows;
    for (std::size_t i = 0; i < scheme.stages.size(); ++i)
        add_product("y_" + std::to_string(i + 1), scheme.stages[i], rows);
    add_product("y", scheme.result, rows);
    add_product("y^", scheme.embedded, rows);
    return rows;
}

}  // namespace

std::vector<SchemeRow> scheme_rows(const std::optional<Scheme>& scheme) {
    if (!scheme) return {};
    if (const auto* lifted = scheme->as<MuntheKaasScheme>()) return rows_of(lifted->tableau);
    if (const auto* product = scheme->as<CrouchGrossmanScheme>()) return rows_of(product->tableau);
    if (const auto* free = scheme->as<CommutatorFreeScheme>()) return rows_of(*free);
    return {};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
