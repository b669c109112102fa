// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/steps/splitting/splitting_conditions.hpp"

#include "tests/judges/steps/recorded_steps.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr std::size_t longest = 7;

/// A word of n letters as a number: its letters are binary digits, B = 1, the last one lowest.
struct Words {
    /// Coefficients, by length and number.
    std::vector<VecX> of = {VecX::Ones(1)};

    Words() {
        for (std::size_t n = 1; n <= longest; ++n) of.emplace_back(VecX::Zero(Eigen::Index(1) << n));
    }
    /// Times exp(c X) from the right.
    void append(const Real& c, int letter) {
        for (std::size_t n = longest; n > 0; --n)  // from long to short: shorter ones are still those before
            for (Eigen::Index w = 0; w < of[n].size(); ++w) {
                Real factor = 1;
                Eigen::Index rest = w;
                for (std::size_t k = 1; k <= n && (rest & 1) == letter; ++k) {
                    rest >>= 1, factor *= c / Real(k);
                    of[n][w] += factor * of[n - k][rest];
                }
            }
    }
};

/// u (BBBA - 3 BBAB + 3 BABB - ABBB) v of n letters, as columns.
MatX vanishing(Eigen::Index n) {
    const Eigen::Index around = n - 4;
    MatX T = MatX::Zero(Eigen::Index(1) << n, around < 0 ? 0 : (around + 1) << around);
    Eigen::Index column = 0;
    for (Eigen::Index left = 0; left <= around; ++left)
        for (Eigen::Index u = 0; u < Eigen::Index(1) << left; ++u)
            for (Eigen::Index v = 0; v < Eigen::Index(1) << (around - left); ++v, ++column)
                for (const auto& [letters, c] :
                     {std::pair(14, 1), std::pair(13, -3), std::pair(11, 3), std::pair(7, -1)})
                    T((((u << 4) + letters) << (around - left)) + v, column) = c;
    return T;
}

}  // namespace

int splitting_order(const std::vector<Real>& kicks, const std::vector<Real>& drifts) {
    Words words;
    for (std::size_t i = 0; i < kicks.size(); ++i) {
        words.append(kicks[i], 1);
        if (i < drifts.size()) words.append(drifts[i], 0);
    }
    Real factorial = 1;
    for (std::size_t n = 1; n <= longest; ++n) {
        factorial *= Real(n);
        const VecX defect = words.of[n] - VecX::Constant(words.of[n].size(), 1 / factorial);
        if (outside_range(vanishing(static_cast<Eigen::Index>(n)), defect).norm() > 1000 * epsilon)
            return static_cast<int>(n) - 1;
    }
    return static_cast<int>(longest);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
