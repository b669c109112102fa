// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/exceptions.hpp"

#include "support/pattern.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

bool covers(const Exception& entry, const Case& tried) {
    const Combination& combination = tried.combination;
    return matches(entry.model, tried.model->name) && matches(entry.transformation, tried.transformation->name) &&
           matches(entry.method, combination.method) && matches(entry.formulation, combination.formulation) &&
           matches(entry.projection, to_text({.method = "",
                                              .formulation = "",
                                              .projection = combination.projection,
                                              .options = {},
                                              .projection_options = combination.projection_options})
                                         .substr(4));
}

}  // namespace

const std::vector<Exception>& exceptions() {
    static const std::vector<Exception> all = {
        {"*", "lengths*", "*", "*", "terze",
         "the identity as weight counts metres and radians alike: what is nearest depends on the unit of length"},
        {"*", "time*", "*", "*", "terze*",
         "either weight counts metres and metres per second alike: what is nearest depends on the unit of time"},
        {"*", "time*", "*", "*", "baumgarte",
         "alpha and beta are rates per second: how they compare with the motion depends on the unit of time"},
        {"*", "lengths*", "*", "*", "*weight=identity",
         "this weight counts metres and radians alike: what is nearest depends on the unit of length"},
        {"*", "restarted", "*", "*", "coordinate_partitioning*",
         "a restart chooses anew which coordinates depend on the others"},
        {"prismatic joints", "moved by 1000 km", "multistep/bliedf2", "SO3xR3", "none",
         "far away its iteration takes changes below eps |x|/h for round-off: they grow until they are larger"},
        {"*", "turned", "baseline/rk4_euler_angles", "*", "*", "Euler angles prefer directions of space"},
        {"*", "bodies in other axes", "baseline/rk4_euler_angles", "*", "*", "Euler angles prefer axes of the body"},
        {"bricard", "*", "baseline/rk4_euler_angles", "*", "*", "links stand where Euler angles are singular"},
        {"bricard", "*", "baseline/rk4_matrix", "*", "position*",
         "R leaves SO(3) by O(h^4), and redundant rows then contradict each other"},
    };
    return all;
}

const Exception* exception_for(const Case& entry) {
    for (const Exception& exception : exceptions())
        if (covers(exception, entry)) return &exception;
    return nullptr;
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
