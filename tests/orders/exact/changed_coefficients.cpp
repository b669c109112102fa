// SPDX-License-Identifier: BSD-3-Clause
//
// A change of any single coefficient of a commutator-free method, or of one with few commutators, lowers an order that
// is declared: that of the step, or of the estimate of its error.
#include <catch2/catch.hpp>

#include "tests/judges/conditions/registered.hpp"
#include "tests/judges/families/scheme_family.hpp"
#include "tests/judges/steps/scheme_checks.hpp"

using namespace kreisel;
using namespace kreisel::orders;

namespace {

/// f(coefficient) for every one, also where it is zero by being written.
template <class F>
void each_coefficient_of(CommutatorFreeScheme& scheme, F f) {
    const auto each = [&](ExponentialProduct& product) {
        for (auto& factor : product.factors)
            for (Coefficient& entry : factor) f(entry);
    };
    for (ExponentialProduct& stage : scheme.stages) each(stage);
    each(scheme.result);
    each(scheme.embedded);
}

template <class F>
void each_coefficient_of(FewCommutatorsScheme& scheme, F f) {
    const auto each = [&](BracketSum& sum) {
        for (Coefficient& entry : sum.weights) f(entry);
        for (BracketTerm& term : sum.brackets) f(term.coefficient);
    };
    for (BracketSum& stage : scheme.stages) each(stage);
    each(scheme.result);
}

/// Off by 1e-6, relative where it is not zero. `digits` holds those of one that is written so.
Coefficient off(const Coefficient& entry, std::string& digits) {
    if (entry.is_zero()) return {1, 1000000};
    if (!entry.digits) return {entry.numerator * 1000001, entry.denominator * 1000000};
    digits = Float100(Float100(entry.digits) * Float100("1.000001")).str(44, std::ios_base::fixed);
    return digits.c_str();
}

template <class Family>
int check_changes() {
    int changes = 0;
    for (const Method* method : registered<Family>()) {
        // What is wrong on purpose has order 2: coefficients that count from order 3 on are free.
        if (method->description.name.starts_with("cautionary/")) continue;
        Method changed = *method;
        Family scheme = *scheme_of<Family>(*method);
        each_coefficient_of(scheme, [&](Coefficient& entry) {
            const Coefficient declared = entry;
            std::string digits;
            entry = off(declared, digits);
            changed.factory.scheme = Scheme(scheme);
            entry = declared;
            INFO(method->description.name << ", coefficient " << ++changes);
            CHECK(order_conditions_objection(changed) != "");
        });
        changed.factory.scheme = Scheme(scheme);
        CHECK(order_conditions_objection(changed) == "");
    }
    return changes;
}

}  // namespace

TEST_CASE("a commutator-free coefficient off by 1e-6 violates a condition", "[commutator_free]") {
    CHECK(check_changes<CommutatorFreeScheme>() >= 30);
}

TEST_CASE("a coefficient of a method with few commutators off by 1e-6 violates a condition", "[few_commutators]") {
    CHECK(check_changes<FewCommutatorsScheme>() >= 15);
}
