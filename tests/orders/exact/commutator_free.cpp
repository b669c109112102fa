// SPDX-License-Identifier: BSD-3-Clause
//
// The conditions of commutator-free methods are those of Crouch-Grossman methods if each factor has one slope, accept
// the published schemes at their order, and detect swapped factors.
#include <catch2/catch.hpp>

#include "tests/judges/conditions/commutator_free_series.hpp"
#include "tests/judges/conditions/registered.hpp"

using namespace kreisel;
using namespace kreisel::orders;

namespace {

using ExactMethod = CommutatorFree<Rational>;

Rational r(int p, int q) { return {p, q}; }

/// Three stages [celledoni2003cf]: y exp(k1/3), y exp(2 k2/3), result y exp(k1/3) exp(-k1/12 + 3 k3/4).
ExactMethod cf3() {
    const std::vector<Rational> third = {r(1, 3)};
    return {.stages = {{}, {third}, {{0, r(2, 3)}}}, .result = {third, {r(-1, 12), 0, r(3, 4)}}};
}

/// Four stages [celledoni2003cf]: y exp(k1/2), y exp(k2/2), y exp(k1/2) exp(k3 - k1/2), result
/// y exp((3 k1 + 2 k2 + 2 k3 - k4)/12) exp((-k1 + 2 k2 + 2 k3 + 3 k4)/12).
ExactMethod cf4() {
    const std::vector<Rational> half = {r(1, 2)};
    return {.stages = {{}, {half}, {{0, r(1, 2)}}, {half, {r(-1, 2), 0, 1}}},
            .result = {{r(1, 4), r(1, 6), r(1, 6), r(-1, 12)}, {r(-1, 12), r(1, 6), r(1, 6), r(1, 4)}}};
}

/// A Crouch-Grossman tableau as products with one slope in each factor.
ExactMethod as_products(const NumericTableau<Rational>& tableau) {
    const auto factors = [](const std::vector<Rational>& row) {
        ExactMethod::Product product;
        for (std::size_t j = 0; j < row.size(); ++j) {
            product.emplace_back(j + 1, Rational(0));
            product.back()[j] = row[j];
        }
        return product;
    };
    ExactMethod method;
    for (const auto& row : tableau.a) method.stages.push_back(factors(row));
    method.result = factors(tableau.b);
    return method;
}

}  // namespace

TEST_CASE("commutator-free conditions contain those of Crouch-Grossman methods", "[commutator_free]") {
    const OrderedForests forests(5);
    for (const Method* method : registered<CrouchGrossmanScheme>()) {
        const auto tableau = exact(scheme_of<CrouchGrossmanScheme>(*method)->tableau);
        CHECK(commutator_free_series(forests, as_products(tableau)) == crouch_grossman_series(forests, tableau));
    }
}

TEST_CASE("published commutator-free schemes have their order and no more", "[commutator_free]") {
    CHECK(commutator_free_order(cf3()) == 3);
    CHECK(commutator_free_order(cf4()) == 4);
}

TEST_CASE("swapped factors and wrong coefficients lower the order", "[commutator_free][control]") {
    ExactMethod swapped = cf4();
    std::swap(swapped.result[0], swapped.result[1]);
    CHECK(commutator_free_order(swapped) == 2);
    ExactMethod stage = cf4();
    std::swap(stage.stages[3][0], stage.stages[3][1]);
    CHECK(commutator_free_order(stage) < 4);
    ExactMethod off = cf4();
    off.result[1][2] *= r(1000001, 1000000);
    CHECK(commutator_free_order(off) == 0);
}
