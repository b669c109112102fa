// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rotations, quaternions and inertias as programs print them: six or eight digits, which no longer satisfy what they
// have to. Internal to the reader. It uses the GNU Scientific Library.
#pragma once

#include <array>

#include "problems/description.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// Takes for a value that round-off made invalid the nearest valid one, with a warning that gives the size
/// of the change: for the largest entry L and the last printed decimal u of the entry with most decimals, at most
/// min(max(2 u, 16 eps L), 1e-5 L) in any entry, eps that of double. Other values are returned as they are, for the
/// engine to judge.
class PrintedNumbers {
  public:
    /// `exact`: changes nothing.
    explicit PrintedNumbers(bool exact = false) : exact_(exact) {}

    /// The polar factor. What is orthogonal to 1e-9 stays as it is.
    Matrix3 rotation(const Node& node, const Matrix3& R) const;
    /// Of norm 1; nothing, after an error, if the norm is further from it than round-off of the text and 1e-9.
    std::optional<std::array<double, 4>> quaternion(const Node& node, const std::array<double, 4>& q) const;
    /// The symmetric part, and of it the nearest for which the triangle inequality of the principal moments holds: with
    /// P = tr(J)/2 - J and its positive part P+, tr(P+) - P+. Nothing, after an error, if J is not symmetric.
    std::optional<Matrix3> inertia(const Node& node, const Matrix3& J) const;

  private:
    bool exact_;
};

}  // namespace kreisel
