// SPDX-License-Identifier: BSD-3-Clause
//
// A method that has the properties it claims is not turned down; on request (tag [list], hidden) prints what methods
// have without claiming it.
#include <catch2/catch.hpp>
#include <iostream>

#include "tests/controls/splitting.hpp"
#include "tests/judges/methods/domains.hpp"

using namespace kreisel;

TEST_CASE("a splitting that claims symplecticity, symmetry, momentum and constraints has them", "[methods][claims]") {
    Method sound = splitting_verlet(false);
    CHECK(symplecticity_objection(sound) == "");
    CHECK(momentum_objection(sound) == "");
    CHECK(constraints_objection(sound) == "");
    sound.description.preserves.push_back({Property::energy, Domain::potential});
    CHECK(energy_objection(sound).find("energy changes by") != std::string::npos);
}

TEST_CASE("a method that runs nowhere cannot claim anything, and one with memory is not a map", "[methods][claims]") {
    Method nowhere = splitting_verlet(false);
    nowhere.factory.declines = [](const System&) { return std::string("anything"); };
    CHECK(symplecticity_objection(nowhere).find("no system") != std::string::npos);
    Method remembering = splitting_verlet(false);
    remembering.description.keeps_memory = true;
    CHECK(symplecticity_objection(remembering).find("remember") != std::string::npos);
}

TEST_CASE("systems are of the smallest class that holds them", "[methods][claims]") {
    const auto domain = [](const char* problem, const char* formulation) {
        const Model model = models::standard(problem);
        return domain_of(model, *make_system(model, formulation));
    };
    CHECK(domain("free_top", "SE3") == Domain::free);
    CHECK(domain("heavy_top", "SO3") == Domain::potential);
    CHECK(domain("heavy_top", "SE3") == Domain::constrained);
    CHECK(domain("flyball_governor", "SE3") == Domain::autonomous);
    CHECK(domain("rolling_disk", "SE3") == Domain::autonomous);
    CHECK(domain("forced_heavy_top", "SO3") == Domain::autonomous);
    CHECK_FALSE(claimed_domain(method("rkmk/rk4").description, Property::symplectic));
}

// Hidden because it tests nothing: it prints what a method preserves beyond what it declares, for whoever declares it.
TEST_CASE("properties found that are not declared", "[.][list]") {
    const std::pair<Property, Objection (*)(const Method&)> properties[] = {
        {Property::symplectic, symplecticity_objection},
        {Property::symmetric, reversal_objection},
        {Property::momentum, momentum_objection},
        {Property::energy, energy_objection},
        {Property::constraints, constraints_objection}};
    for (Method entry : methods())
        for (const auto& [property, objection] : properties)
            for (const Domain domain : {Domain::autonomous, Domain::constrained, Domain::potential, Domain::free}) {
                const MethodDescription declared = entry.description;
                if (declared.claims(property, domain)) break;
                entry.description.preserves = {{property, domain}};
                const bool found = objection(entry).empty();
                entry.description = declared;
                if (!found) continue;
                std::cout << entry.description.name << " is " << name(property) << " on " << name(domain)
                          << " systems, and does not declare it\n";
                break;
            }
}
