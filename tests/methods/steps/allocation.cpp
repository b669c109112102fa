// SPDX-License-Identifier: BSD-3-Clause
//
// A step allocates nothing: the calls of the global allocator are counted while each method and projection steps.
#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/methods/control/controlled_trip.hpp"
#include "tests/methods/linkages.hpp"

namespace {

std::atomic<long> allocations{0};

}  // namespace

// Eigen calls malloc, not operator new, which calls malloc too.
#if defined(__SANITIZE_ADDRESS__)  // malloc belongs to the sanitizer: Eigen's allocations are not counted
// Not inlined: GCC would see malloc on one side and operator delete on the other, and warn of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {  // Catch allocates this one
    ++allocations;
    return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#else
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_realloc(void*, std::size_t);
void* malloc(std::size_t size) {
    ++allocations;
    return __libc_malloc(size);
}
void* realloc(void* memory, std::size_t size) {
    ++allocations;
    return __libc_realloc(memory, size);
}
}
#endif

using namespace kreisel;
using namespace models;
using namespace stepping;

/// There each method runs by itself, and one of them with each projection and in each formulation.
bool is_tried_in_quad(const Method& entry, const ProjectionMethod& projector, const std::string& formulation) {
    const bool is_plain = projector.description.name == "none" && formulation == "SO3xR3";
    return is_plain || entry.description.name == "rkmk/rk4";
}

/// Feedback per step has h times its eigenvalues at z = -1 +- i, which 1 + z + ... + z^4/24 + a z^5 is to damp. Of cg43
/// a = b_5 a_54 a_43 a_32 a_21 is 0.97, 117 times 1/120: errors grow fivefold a step.
bool runs_away(const Method& entry, const ProjectionMethod& projector) {
    return entry.description.name == "crouch_grossman/cg43" && projector.description.name == "baumgarte_step";
}

TEST_CASE("a step and a projection allocate nothing", "[methods]") {
    for (const Method& entry : methods())
        for (const ProjectionMethod& projector : projections())
            for (const Named& named : for_methods())
                for (const std::string& formulation : applicable(named.model)) {
                    if (KREISEL_QUAD && named.name != "heavy_top") continue;  // slow, and the same code
                    if (KREISEL_QUAD && !is_tried_in_quad(entry, projector, formulation)) continue;
                    if (!runs_on(entry, named.model, formulation)) continue;
                    if (!go_together(entry.description, projector) || runs_away(entry, projector)) continue;
                    if (!runs_on(projector.description, named.model, formulation)) continue;
                    Trip trip(named.model, formulation, entry, projector.description.name);
                    const long before = allocations;
                    const Status status = trip.run(Real(1) / 100, KREISEL_QUAD ? 2 : 10);
                    const long during = allocations - before;
                    INFO(entry.description.name << ", " << projector.description.name << ", " << named.name << ", "
                                                << formulation);
                    CHECK(status == Status::ok);
                    CHECK(during == 0);
                }
}

TEST_CASE("steps to a tolerance allocate nothing", "[methods]") {
    for (const Method& entry : methods())
        for (const char* projector : {"none", "position_velocity", "coordinate_partitioning", "baumgarte"}) {
            if (entry.description.estimate == 0 && !entry.description.own_control) continue;
            const Model model = standard("double_pendulum");
            ControlledTrip trip(model, "SO3xR3", entry, {.tolerance = Real(1) / 100000, .length = 1}, projector);
            Real t = 0;
            const long before = allocations;
            Status status = trip.stepper->start(t, 1, trip.y.data());
            while (status == Status::ok && t < Real(1) / 10) status = trip.stepper->step(t, 1, trip.y.data());
            const long during = allocations - before;
            INFO(entry.description.name << ", " << projector);
            CHECK(status == Status::ok);
            CHECK(during == 0);
        }
}

TEST_CASE("an implicit step on redundant rows allocates nothing", "[methods]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    for (const Method& entry : methods())
        for (const Named& named : linkages::redundant_linkages()) {
            if (!entry.description.is_implicit()) continue;
            if (!runs_on(entry, named.model, "SO3xR3")) continue;
            Trip trip(named.model, "SO3xR3", entry);
            const long before = allocations;
            const Status status = trip.run(Real(1) / 100, 10);
            const long during = allocations - before;
            INFO(entry.description.name << ", " << named.name);
            CHECK(status == Status::ok);
            CHECK(during == 0);
        }
}

TEST_CASE("the count above sees an allocation", "[methods][control]") {
    const long before = allocations;
    const std::vector<Real> memory(10);
    CHECK(allocations - before == 1);
    CHECK(memory.size() == 10);
    const VecX vector = VecX::Zero(10);
#if !defined(__SANITIZE_ADDRESS__)
    CHECK(allocations - before == 2);
#endif
    CHECK(vector.norm() == 0);
}
