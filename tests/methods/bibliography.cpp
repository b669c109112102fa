// SPDX-License-Identifier: BSD-3-Clause
//
// Every method and projection cites keys that the bibliography has.
#include "tests/support/bibliography.hpp"

#include "methods/contract/method.hpp"
#include "methods/contract/projection.hpp"

using namespace kreisel;

TEST_CASE("citations of methods and projections are in the bibliography", "[methods]") {
    for (const Method& entry : methods()) {
        INFO(entry.description.name);
        CHECK_FALSE(entry.description.cites.empty());
        check_cites(entry.description.name, entry.description.cites);
    }
    for (const ProjectionMethod& entry : projections()) check_cites(entry.description.name, entry.description.cites);
    CHECK_FALSE(bibliography().contains("nobody1900"));
}
