// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/predictor.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

void Predictor::push(const VecX& value) {
    next_ = value;
    Real* const next = next_.data();
    for (int k = 0; k <= min(known_, most_); ++k) {
        Real* const difference = differences_[static_cast<std::size_t>(k)].data();
        KREISEL_ELEMENTWISE
        for (Eigen::Index i = 0; i < next_.size(); ++i) {
            const Real old = difference[i];
            difference[i] = next[i];
            next[i] -= old;
        }
    }
    known_ = min(known_ + 1, most_ + 1);
}

int Predictor::best_degree(Eigen::Index entries) const {
    int best = 0;
    Real least = 0;
    for (int k = 1; k < known_; ++k) {  // difference k is the error of degree k - 1
        const VecX& difference = differences_[static_cast<std::size_t>(k)];
        Real error = 0;
        for (Eigen::Index i = 0; i < entries; ++i) error = max(error, Real(abs(difference[i])));
        if (k > 1 && error >= least) continue;
        least = error, best = k - 1;
    }
    return best;
}

void Predictor::guess(int degree, VecX& value) const {
    value = differences_[0];
    for (int k = 1; k <= min(degree, known_ - 1); ++k) value += differences_[static_cast<std::size_t>(k)];
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
