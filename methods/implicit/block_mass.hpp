// SPDX-License-Identifier: BSD-3-Clause
//
// Momenta p = M v: the product that System leaves out, by its blocks.
#pragma once

#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class BlockMass {
  public:
    explicit BlockMass(const System& system)
        : system_(system), blocks_(static_cast<std::size_t>(system.velocities() * system.mass_block())) {}

    /// Takes the masses at q.
    void weigh(const Real* q) { system_.mass(q, blocks_.data()); }
    /// p = M v, in different storage.
    void multiply(const Real* v, Real* p) const {
        const int rows = system_.mass_block();
        for (int i = 0; i < system_.velocities(); ++i) {
            p[i] = 0;
            const int first = i - i % rows;
            for (int k = 0; k < rows; ++k)
                p[i] += blocks_[static_cast<std::size_t>((first + k) * rows + i % rows)] * v[first + k];
        }
    }

  private:
    const System& system_;
    std::vector<Real> blocks_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
