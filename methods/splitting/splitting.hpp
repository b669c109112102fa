// SPDX-License-Identifier: BSD-3-Clause
//
// Splitting of the equations of motion of bodies without joints, y' = A(y) + B(t, y):
//   A, free motion:  x'' = 0,  R' = R omega~,  J omega' = (J omega) x omega,  t' = 1,
//   B, a kick:       M v' = f(t, q),  f the conservative force,
// each of which has an exact flow, A in elliptic functions [celledonifasso2008]. A step is
//   exp(b_1 h B) exp(a_1 h A) exp(b_2 h B) ... exp(a_s h A) exp(b_{s+1} h B),
// factors acting from left to right. Time is a coordinate that moves with A and stands still during kicks, so the
// orders hold for forces that depend on time. Symplectic where f has a potential, symmetric where the lists are
// palindromes, which all are. Sources: [mclachlanquispel2002], [hairer2006, Secs. II.5, VII.5.4].
#pragma once

#include <vector>

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// b_1, b_2, ... and a_1, a_2, ... up to the middle, the rest being their mirror image: s is odd with as many kicks as
/// drifts, whose last is the middle, and even with one kick more. Schemes that begin with a drift have b_1 = 0, a kick
/// that costs nothing.
struct SplittingScheme {
    std::vector<Coefficient> kicks, drifts;
};

Factory splitting(const SplittingScheme& scheme);

/// What all of the family preserve.
std::vector<Claim> preserved_by_splitting();

/// SE3 would have the same states as SO3xR3, to round-off.
inline const std::vector<std::string> formulations_of_splitting = {"SO3", "S3", "SO3xR3", "S3xR3"};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
