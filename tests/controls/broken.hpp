// SPDX-License-Identifier: BSD-3-Clause
//
// Families with their faults as switches; with every switch off they are the correct methods.
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Munthe-Kaas methods, u' = dexpinv_{-u}(k) in canonical coordinates.
struct MuntheKaasFault {
    enum class Dexpinv { right, absent, wrong_sign } dexpinv = Dexpinv::right;  ///< wrong sign: dexpinv_{+u}
    enum class Nodes { right, start, middle } nodes = Nodes::right;             ///< every stage at t_n, at t_n + h/2
    bool stale_slope = false;      ///< the slope at the end of a step is reused as the first one of any later step
    bool uncounted_solve = false;  ///< the first slope is computed twice, once uncounted
    bool deaf = false;             ///< failed stages are accepted, NaN entries replaced by zero
    bool turns_space = false;      ///< space is rotated and shifted by h^3 after each step
};
Factory broken_rkmk(const Tableau& declared, MuntheKaasFault fault);
/// Declares one tableau and steps with another.
Factory broken_rkmk(const Tableau& declared, MuntheKaasFault fault, const Tableau& used);

/// Lie midpoint method that stops after two fixed-point iterations and reports convergence.
Factory unconverged_midpoint();

/// A method projected after each step: of a symmetric method no longer symmetric.
Factory projected_at_the_end(const std::string& base);

/// Crouch-Grossman methods.
struct CrouchGrossmanFault {
    bool reversed_stage_factors = false;  ///< exp(h a_i,i-1 K_{i-1}) ... exp(h a_i1 K_1)
    bool reversed_final_factors = false;  ///< exp(h b_s K_s) ... exp(h b_1 K_1)
    bool reversed_rows = false;           ///< a_ij given to stage i - j
};
Factory broken_crouch_grossman(const Tableau& declared, CrouchGrossmanFault fault);

/// The extrapolation of two rows in h^2, of a base method that is not symmetric, so that its error has odd powers too.
/// Declares the rule on the group.
Factory one_sided_extrapolation();

/// RATTLie with its momentum p, which is carried along by transposed differentials, replaced by M v of the stage and
/// half of its gyroscopic impulse: M D = p + h/2 (f + gyroscopic(D) - C^T lambda'), and from there to p+ alike. Of
/// order 2 and symmetric like RATTLie; neither the two-form nor momenta are kept.
Factory rattlie_with_stage_momentum();

/// An embedded pair of orders 3 and 2, first same as last, by attempts.
struct PairFault {
    bool doubled_error = false;       ///< the estimate is twice the difference of the solutions
    bool keeps_rejected = false;      ///< every attempt counts as accepted: the next one starts from its last slope
    bool ignores_projection = false;  ///< the last slope is the first of the next step, though the state has moved
};
Method broken_pair(const std::string& name, PairFault fault);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
