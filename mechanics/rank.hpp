// SPDX-License-Identifier: BSD-3-Clause
//
// Which constraint rows are independent. Cholesky factors of C M^{-1} C^T cannot tell: they lose half of the digits, and
// partial pivoting answers a redundant row with a number. A QR factorisation with column pivoting of M^{-1/2} C^T can, its
// columns scaled to length 1 so that units and arms do not matter [golubvanloan2013, Sec. 5.4].
#pragma once

#include <optional>
#include <vector>

#include "mechanics/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Below this ratio of pivots a row counts as dependent: a start may violate its joints by 1e-9, and rows that depend on
/// each other on the constraints do so only up to such a violation.
inline const Real dependence = Real(1) / 10000000;

struct RowChoice {
    std::vector<bool> independent;  ///< of each column of the matrix
    int rank = 0;
    std::optional<Real> condition;  ///< ratio of the first pivot to the last one that counts
};

/// The columns of A = M^{-1/2} C^T that pivoting takes first, at most `most` of them.
RowChoice choose_rows(const MatX& A, int most);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
