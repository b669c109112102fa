// SPDX-License-Identifier: BSD-3-Clause
//
// Whether time drives a joint. What holds a coordinate where it is, by a law that does not change, does no work.
#pragma once

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

inline bool is_constant(const Prescribed& law) {
    for (std::size_t k = 1; k < law.polynomial.size(); ++k)
        if (law.polynomial[k] != 0) return false;
    for (const Sinusoid& one : law.sinusoids)
        if (one.amplitude != 0 && one.frequency != 0) return false;
    return true;
}

/// Whether the rows of a joint depend on time.
inline bool is_driven(const Joint& joint) {
    return (joint.amplitude != 0 && joint.frequency != 0) || !is_constant(joint.turn) || !is_constant(joint.shift);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
