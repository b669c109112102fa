// SPDX-License-Identifier: BSD-3-Clause
//
// Eigenvalues of real matrices, those that belong together counted as one.
#pragma once

#include <vector>

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct SpectrumEntry {
    Real real, imaginary;
    int multiplicity = 1;
};

/// The eigenvalues of a square matrix by the QR algorithm [golubvanloan2013, Sec. 7.5], by falling real part and,
/// within one, by rising frequency, that with the positive imaginary part first. Those within `unit` times the cube
/// root of round-off of one another are one of that multiplicity, their mean (an eigenvalue with a block of three
/// splits by the cube root of a perturbation, its mean moves by the perturbation). Throws std::domain_error
/// if the algorithm does not converge.
std::vector<SpectrumEntry> spectrum(const MatX& A, const Real& unit);

/// Largest distance of an eigenvalue of one spectrum from the nearest of the other.
Real distance(const std::vector<SpectrumEntry>& a, const std::vector<SpectrumEntry>& b);

/// Below this, of a spectrum in `unit`, eigenvalues are one, or zero.
Real same_eigenvalue(const Real& unit);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
