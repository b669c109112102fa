// SPDX-License-Identifier: BSD-3-Clause
//
// Orthonormal directions, the last of those that came one after another.
#pragma once

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class Directions {
  public:
    /// Room for `most` of them.
    Directions(Eigen::Index unknowns, Eigen::Index most) : columns_(unknowns, most) {}

    Eigen::Index most() const { return columns_.cols(); }
    void clear() { found_ = 0; }
    /// Takes from p its part in the last `keep` directions, normalises the rest and adds it. Returns the length of the
    /// rest, or 0 if it is at most 1/share of the whole: then nothing is added, and p is not normalised.
    Real add(VecX& p, int share, Eigen::Index keep) {
        const Real whole = p.norm();
        for (Eigen::Index i = 0; i < min(found_, keep); ++i) p -= columns_.col(i).dot(p) * columns_.col(i);
        const Real length = p.norm();
        if (!(share * length > whole)) return 0;
        p /= length;
        columns_.col(found_++ % keep) = p;
        return length;
    }

  private:
    MatX columns_;
    Eigen::Index found_ = 0;  // since the last clear
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
