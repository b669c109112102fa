// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/system.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

Status System::solve_kkt(const Real&, const Real*, const Real* f, const Real*, Real* a, Real*) {
    std::copy_n(f, velocities(), a);  // unit mass, no constraints
    return Status::ok;
}

void System::mass(const Real*, Real* blocks) const {
    const int size = mass_block();
    for (int block = 0; block < velocities() / size; ++block, blocks += size * size)
        Eigen::Map<MatX>(blocks, size, size).setIdentity();
}

void System::applied_force(const Real&, const Real*, const Real*, Real* f) const {
    std::fill_n(f, velocities(), Real(0));
}

void System::gyroscopic_force(const Real*, const Real*, Real* f) const { std::fill_n(f, velocities(), Real(0)); }

void System::velocity_bias(const Real&, const Real*, Real* b) const { std::fill_n(b, constraints(), Real(0)); }

void System::row_scale(Real* scale) const { std::fill_n(scale, constraints(), Real(1)); }

void System::position_scale(const Real*, Real* scale) const { std::fill_n(scale, position_constraints(), Real(1)); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
