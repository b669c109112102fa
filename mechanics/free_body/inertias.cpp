// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/free_body/inertias.hpp"

#include <limits>

namespace kreisel {
inline namespace KREISEL_PRECISION {

BodyInertias::BodyInertias(const System& system)
    : system_(system),
      bodies_(system.bodies()),
      block_(system.mass_block()),
      blocks_(static_cast<std::size_t>(system.velocities() * block_)),
      known_(blocks_.size(), std::numeric_limits<Real>::quiet_NaN()) {}  // unlike any

bool BodyInertias::weigh(const Real* q) {
    system_.mass(q, blocks_.data());
    if (blocks_ == known_) return false;
    known_ = blocks_;
    return true;
}

Mat3 BodyInertias::of(int body) const {
    const Real* block = blocks_.data() + body * block_ * block_;
    const int corner = block_ - pivoted_;
    return Eigen::Map<const MatX>(block, block_, block_).block<3, 3>(corner, corner);
}

std::string BodyInertias::why_not(const System& system) {
    if (system.constraints() > 0) return "joints";
    const int block = system.mass_block();
    const bool rigid = block == pivoted_ || block == free_;
    return rigid && system.bodies() * block == system.velocities() ? "" : "systems other than rigid bodies";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
