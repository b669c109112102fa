// SPDX-License-Identifier: BSD-3-Clause
//
// Relations that need one evaluation of the dynamics: a joint replaced by its reaction, a model written and read back.
#include <catch2/catch.hpp>
#include <iostream>

#include "mechanics/formulation.hpp"
#include "tests/metamorphic/descriptions/freed.hpp"
#include "tests/metamorphic/descriptions/written.hpp"
#include "tests/metamorphic/models/named_models.hpp"

using namespace kreisel;
using namespace kreisel::metamorphic;

namespace {

VecX accelerations_at_start(const Model& model) {
    const auto system = make_system(model, "SO3xR3");
    const std::vector<Real> y = initial_state(*system, model);
    VecX dv(system->velocities());
    REQUIRE(system->accelerations(0, y.data(), system->v(y.data()), dv.data(), nullptr) == Status::ok);
    return dv;
}

}  // namespace

TEST_CASE("a joint may give way to its reaction", "[metamorphic]") {
    int joints = 0;
    for (const NamedModel& named : named_models()) {
        INFO(named.name);
        if (!named.model.joints.empty()) CHECK(freed_difference(named.model) <= 1000000 * epsilon);
        joints += static_cast<int>(named.model.joints.size());
    }
    std::cout << joints << " joints gave way to their reactions\n";
    CHECK(joints >= 140);
}

TEST_CASE("a model that is written down and read again is the same", "[metamorphic]") {
    int models = 0;
    for (const NamedModel& named : named_models()) {
        const auto again = read_again(named.model);
        if (!again) continue;
        INFO(named.name);
        ++models;
        const VecX a = accelerations_at_start(named.model), b = accelerations_at_start(*again);
        Model loose = named.model;  // if joints hold all bodies at rest, accelerations are round-off of these
        loose.joints.clear();
        const Real size = max(Real(a.norm()), Real(accelerations_at_start(loose).norm()));
        CHECK((a - b).norm() <= size / 1000000000);  // data are decimals of double precision
    }
    std::cout << models << " models were read again\n";
    CHECK(models >= 25);
}
