// SPDX-License-Identifier: BSD-3-Clause
#include "methods/extrapolation/neville.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

NevilleTable::NevilleTable(int columns, int dimension)
    : rows_(static_cast<std::size_t>(columns), std::vector<Real>(static_cast<std::size_t>(dimension))),
      difference_(static_cast<std::size_t>(dimension)) {}

void NevilleTable::extrapolate(int j) {
    const int n = substeps(j);
    for (int before = j - 1; before > 0; --before) {
        const int m = substeps(before);
        const Real factor = Real(m * m) / Real(n * n - m * m);
        const Real* fine = row(before + 1);
        Real* coarse = row(before);
        for (std::size_t c = 0; c < difference_.size(); ++c) {
            difference_[c] = factor * (fine[c] - coarse[c]);
            coarse[c] = fine[c] + difference_[c];
        }
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
