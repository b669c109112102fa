// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/predictor.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

void Predictor::push(const VecX& value) {
    next_ = value;
    for (int k = 0; k <= most_; ++k) {
        VecX& difference = differences_[static_cast<std::size_t>(k)];
        difference.swap(next_);  // of the new value; next_ is that of the old one
        if (k == known_) break;
        next_ = difference - next_;
    }
    known_ = min(known_ + 1, most_ + 1);
}

int Predictor::best_degree(const VecX& weights) const {
    int best = 0;
    Real least = 0;
    if (weights.size() == 0) return best;
    for (int k = 1; k < known_; ++k) {  // difference k is the error of degree k - 1
        const Real error = differences_[static_cast<std::size_t>(k)].cwiseProduct(weights).cwiseAbs().maxCoeff();
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
