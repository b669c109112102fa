// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The series of the modified moments of inertia, 1/I~_j = s/I_j + d [hairervilmart2006, Sec. 3; coefficients from
/// their program].
class ModifiedMoments {
  public:
    static constexpr int most_terms = 4;

    ModifiedMoments(const Vec3& I, int terms);
    /// 1/I~ for the momentum m in principal axes and steps by h.
    Vec3 inverse(const Vec3& m, const Real& h) const;

  private:
    /// Coefficients of C^k, C^(k-1) H, ..., H^k in s_{2k+1} and d_{2k+1}, k = 1, 2, ...
    using Polynomials = std::array<std::array<Real, most_terms + 1>, most_terms>;

    Vec3 inverse_;
    int terms_;
    Polynomials s_ = {}, d_ = {};
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
