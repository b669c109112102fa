// SPDX-License-Identifier: BSD-3-Clause
#include "engine/linearised/spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Real apart(const SpectrumEntry& a, const SpectrumEntry& b) {
    const Real x = a.real - b.real, y = a.imaginary - b.imaginary;
    return sqrt(x * x + y * y);
}

/// Adds one eigenvalue to the entry it belongs to, whose mean moves.
void count_in(std::vector<SpectrumEntry>& entries, const SpectrumEntry& one, const Real& near) {
    for (SpectrumEntry& entry : entries)
        if (apart(entry, one) <= near) {
            ++entry.multiplicity;
            entry.real += (one.real - entry.real) / entry.multiplicity;
            entry.imaginary += (one.imaginary - entry.imaginary) / entry.multiplicity;
            return;
        }
    entries.push_back(one);
}

}  // namespace

Real same_eigenvalue(const Real& unit) { return cbrt(epsilon) * unit; }

std::vector<SpectrumEntry> spectrum(const MatX& A, const Real& unit) {
    std::vector<SpectrumEntry> entries;
    if (A.rows() == 0) return entries;
    using std::floor;
    const Real near = same_eigenvalue(unit);
    const Eigen::EigenSolver<MatX> solver(A, false);
    if (solver.info() != Eigen::Success) throw std::domain_error("the eigenvalues: the QR algorithm did not converge");
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        count_in(entries, {solver.eigenvalues()[i].real(), solver.eigenvalues()[i].imag()}, near);
    // Compared by bins: what is near is not an order, since it is not transitive.
    const auto bin = [&](const Real& x) { return floor(x / near + Real(1) / 2); };
    const auto key = [&](const SpectrumEntry& e) {
        return std::tuple(-bin(e.real), bin(abs(e.imaginary)), -bin(e.imaginary));
    };
    std::sort(entries.begin(), entries.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    return entries;
}

Real distance(const std::vector<SpectrumEntry>& a, const std::vector<SpectrumEntry>& b) {
    Real largest = 0;
    for (const SpectrumEntry& one : a) {
        Real nearest = b.empty() ? Real(0) : apart(one, b[0]);
        for (const SpectrumEntry& other : b) nearest = min(nearest, apart(one, other));
        largest = max(largest, nearest);
    }
    return largest;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
