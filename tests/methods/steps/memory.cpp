// SPDX-License-Identifier: BSD-3-Clause
//
// What methods remember from step to step: nothing that a step of another length or one that fails leaves behind.
#include "tests/methods/stepping.hpp"

namespace memory_of_methods {

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

const Real h = Real(1) / 256;
constexpr int before = 5;  // as many as fill the memory of any method

/// After some steps, and then `spoil`, a step by `next` is that of an integrator that has seen none of them.
template <class Spoil>
bool starts_afresh(const Method& entry, const Model& model, const std::string& formulation, const Real& next,
                   Spoil spoil, int steps = before) {
    Trip used(model, formulation, entry), fresh(model, formulation, entry);
    REQUIRE(used.run(steps * h, steps) == Status::ok);
    spoil(used);
    fresh.y = used.y;
    REQUIRE(fresh.integrator->start(steps * h, fresh.y.data()) == Status::ok);
    for (Trip* trip : {&used, &fresh}) REQUIRE(trip->integrator->step(steps * h, next, trip->y.data()) == Status::ok);
    return used.y == fresh.y;
}

void fail_once(Trip& trip) {
    std::vector<Real> y = trip.y;
    y.back() = std::numeric_limits<Real>::quiet_NaN();
    REQUIRE(trip.integrator->step(before * h, h, y.data()) != Status::ok);
}

template <class F>
void for_each_with_memory(F f) {
    for (const Method& entry : methods())
        for (const auto& [problem, formulation] :
             {std::pair("double_pendulum", "SO3xR3"), std::pair("forced_heavy_top", "SO3-LiePoisson"),
              std::pair("free_top", "SO3xR3")}) {
            const Model model = standard(problem);
            if (!runs_on(entry, model, formulation)) continue;
            INFO(entry.description.name << " on " << problem);
            f(entry, model, formulation);
        }
}

}  // namespace

TEST_CASE("a step of another length starts afresh", "[methods][memory]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    for_each_with_memory([](const Method& entry, const Model& model, const std::string& formulation) {
        for (const Real& next : {Real(h / 2), Real(2 * h)})
            CHECK(starts_afresh(entry, model, formulation, next, [](Trip&) {}));
    });
}

TEST_CASE("a step after one that fails starts afresh", "[methods][memory]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    for_each_with_memory([](const Method& entry, const Model& model, const std::string& formulation) {
        CHECK(starts_afresh(entry, model, formulation, h, fail_once));
    });
}

TEST_CASE("a step of the same length after one that does not fail does not", "[methods][memory][control]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    for (const char* name : {"multistep/adams_bashforth2", "multistep/bliedf2", "symmetric_projection/gauss2",
                             "variational/rattlie", "rkmk/gauss2", "rkmk/implicit_midpoint"}) {
        INFO(name);
        bool afresh = true;  // a single step may converge to the same bits from another guess
        for (int steps = before; steps < before + 8; ++steps)
            afresh &= starts_afresh(
                method(name), standard("double_pendulum"), "SO3xR3", h, [](Trip&) {}, steps);
        CHECK_FALSE(afresh);
    }
}

}  // namespace memory_of_methods
