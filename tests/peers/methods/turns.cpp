// SPDX-License-Identifier: BSD-3-Clause
//
// Torsion springs that turn several times: turns are counted, or lost, which must be a status.
#include "tests/mechanics/models/turning.hpp"
#include "tests/peers/methods/approach.hpp"

using namespace kreisel;
using namespace peers;

namespace {

Real theta(const Approach& run) {
    std::vector<SpringAngle> angles(1);
    run.system->read_angles(run.y.data(), angles.data());
    return angles[0].theta;
}

}  // namespace

TEST_CASE("springs through several turns follow their closed form by every baseline", "[peers]") {
    for (const models::Turner& turner : {models::wheel("revolute", 10), models::wheel("revolute", -30, 1)})
        for (const Method& entry : baselines())
            for (const OptionValues& options : variants(entry))
                for (const Real& tolerance : {Real(1) / 1000, Real(1) / 1000000}) {
                    Approach run(turner.model, "SO3xR3", entry, options, tolerance);
                    INFO(entry.description.name << text(options) << " to " << to_double(tolerance) << ", "
                                                << turner.name);
                    const Status status = run.run({1});
                    if (tolerance > Real(1) / 10000 && status == Status::turn_lost) continue;
                    REQUIRE(status == Status::ok);
                    CHECK(to_double(abs(theta(run) - turner.exact(1).first)) < 3000 * to_double(tolerance));
                }
}
