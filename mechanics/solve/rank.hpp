// SPDX-License-Identifier: BSD-3-Clause
//
// Which constraint rows are independent. Cholesky factors of C M^{-1} C^T cannot tell: they lose half of the digits,
// and partial pivoting gives a number even for a redundant row. A QR factorisation with column pivoting of C^T can, its
// columns scaled to length 1 [golubvanloan2013, Sec. 5.4]. The rank is geometric: torques are divided by a length of
// their body, so units do not matter, and masses do not enter.
#pragma once

#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Below this ratio of pivots a row counts as dependent: a start may violate its joints by 1e-9, and rows that depend
/// on each other on the constraints do so only up to such a violation.
inline const Real dependence = Real(1) / 10000000;

struct RowChoice {
    std::vector<bool> independent;  ///< of each column of the matrix
    int rank = 0;
};

/// The columns of A = C^T, torques divided by lengths, that pivoting takes first, at most `most` of them.
RowChoice choose_rows(const MatX& A, int most);

/// Ratio of the first pivot of A to the last one, its columns scaled to length 1; infinite where columns are dependent.
Real pivot_ratio(const MatX& A);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
