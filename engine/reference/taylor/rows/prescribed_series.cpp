// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/rows/prescribed_series.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

void expand(const Prescribed& law, const Real& t, Scalars& series) {
    std::fill(series.begin(), series.end(), Real(0));
    std::vector<Real> rest = law.polynomial;  // divided by (x - t) again and again: what remains are the coefficients
    for (std::size_t k = 0; k < rest.size() && k < series.size(); ++k) {
        for (std::size_t j = rest.size() - 1; j-- > k;) rest[j] += t * rest[j + 1];
        series[k] = rest[k];
    }
    for (const auto& [amplitude, frequency, phase] : law.sinusoids) {
        const Real angle = frequency * t + phase, derivatives[] = {sin(angle), cos(angle), -sin(angle), -cos(angle)};
        Real factor = amplitude;
        for (std::size_t k = 0; k < series.size(); factor *= frequency / real(++k))
            series[k] += factor * derivatives[k % 4];
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
