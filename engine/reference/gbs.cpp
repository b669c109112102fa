// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/gbs.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace kreisel {
inline namespace KREISEL_PRECISION {

ExtrapolationTable even_sequence(int columns) {
    ExtrapolationTable table;
    for (int n = 2; n <= 2 * columns; n += 2) {
        table.steps.push_back(n);
        table.abscissae.push_back(Real(1) / (n * n));
    }
    return table;
}

Extrapolation::Extrapolation(ExtrapolationTable table, int dimension, Rate rate)
    : table_(std::move(table)), rate_(std::move(rate)) {
    const auto odd = [](int n) { return n < 2 || n % 2 != 0; };
    if (table_.steps.empty() || table_.abscissae.size() != table_.steps.size() ||
        std::any_of(table_.steps.begin(), table_.steps.end(), odd))
        throw std::invalid_argument("extrapolation needs an abscissa and an even number of substeps for every row");
    const auto d = static_cast<std::size_t>(dimension);
    for (auto* v : {&start_rate_, &slope_, &before_, &difference_}) v->assign(d, Real(0));
    rows_.assign(table_.steps.size(), std::vector<Real>(d));
}

Status Extrapolation::midpoint(const Real& t, const Real& H, int steps, const Real* w, std::vector<Real>& end) {
    const Real h = H / steps, h2 = 2 * h;
    const std::size_t d = end.size();
    std::copy(w, w + d, before_.begin());
    for (std::size_t i = 0; i < d; ++i) end[i] = w[i] + h * start_rate_[i];
    for (int k = 1; k < steps; ++k) {
        if (const Status s = rate_(t + k * h, end.data(), slope_.data()); s != Status::ok) return s;
        for (std::size_t i = 0; i < d; ++i) before_[i] += h2 * slope_[i];
        std::swap(before_, end);
    }
    return Status::ok;
}

/// T_{j,i+1} = T_{j,i} + (T_{j,i} - T_{j-1,i}) / (x_{j-i}/x_j - 1), i = 1 ... j-1 [hairer1993, eq. (II.9.10)].
void Extrapolation::extrapolate(std::size_t row) {
    for (std::size_t i = row; i-- > 0;) {
        const Real factor = 1 / (table_.abscissae[i] / table_.abscissae[row] - 1);
        const std::vector<Real>& fine = rows_[i + 1];
        std::vector<Real>& coarse = rows_[i];
        for (std::size_t c = 0; c < coarse.size(); ++c) {
            difference_[c] = factor * (fine[c] - coarse[c]);
            coarse[c] = fine[c] + difference_[c];
        }
    }
}

Status Extrapolation::step(const Real& t, const Real& H, Real* w) {
    if (const Status s = rate_(t, w, start_rate_.data()); s != Status::ok) return s;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        if (const Status s = midpoint(t, H, table_.steps[row], w, rows_[row]); s != Status::ok) return s;
        extrapolate(row);
    }
    for (const Real& value : rows_[0])
        if (!isfinite(value)) return Status::non_finite;
    std::copy(rows_[0].begin(), rows_[0].end(), w);
    return Status::ok;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
