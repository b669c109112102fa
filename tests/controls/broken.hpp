// SPDX-License-Identifier: BSD-3-Clause
//
// The two families with their faults as switches; with every switch off they are the correct methods.
#pragma once

#include "methods/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Munthe-Kaas methods, u' = dexpinv_{-u}(k) in canonical coordinates.
struct MuntheKaasFault {
    enum class Dexpinv { right, absent, wrong_sign } dexpinv = Dexpinv::right;  ///< wrong sign: dexpinv_{+u}
    bool frozen_time = false;                                                   ///< every stage evaluated at t_n
};
Factory broken_rkmk(const Tableau& declared, MuntheKaasFault fault);

/// Crouch-Grossman methods.
struct CrouchGrossmanFault {
    bool reversed_stage_factors = false;  ///< exp(h a_i,i-1 K_{i-1}) ... exp(h a_i1 K_1)
    bool reversed_final_factors = false;  ///< exp(h b_s K_s) ... exp(h b_1 K_1)
    bool reversed_rows = false;           ///< a_ij given to stage i - j
};
Factory broken_crouch_grossman(const Tableau& declared, CrouchGrossmanFault fault);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
