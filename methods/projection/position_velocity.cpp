// SPDX-License-Identifier: BSD-3-Clause
#include "methods/projection/gauss_newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class PositionVelocityProjection final : public GaussNewtonProjection {
  public:
    using GaussNewtonProjection::GaussNewtonProjection;
    Status project(const Real& t, Real* y) override {
        const Status status = project_position(t, y);
        return status == Status::ok ? project_velocity(t, y) : status;
    }
};

}  // namespace

KREISEL_PROJECTION({.name = "position_velocity",
                    .summary = "positions first, then velocities at the new position; mass-weighted, group updates",
                    .cites = {"eich1993"},
                    .positions = true,
                    .velocities = true},
                   [](System& system, const OptionValues&) {
                       return std::make_unique<PositionVelocityProjection>(system);
                   });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
