// SPDX-License-Identifier: BSD-3-Clause
#include "methods/projection/gauss_newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class VelocityProjection final : public GaussNewtonProjection {
  public:
    using GaussNewtonProjection::GaussNewtonProjection;
    Status project(const Real& t, Real* y) override { return project_velocity(t, y); }
};

}  // namespace

KREISEL_PROJECTION({.name = "velocity",
                    .summary = "velocities onto C v + b = 0, mass-weighted",
                    .cites = {"eich1993"},
                    .velocities = true},
                   [](System& system, const OptionValues&) { return std::make_unique<VelocityProjection>(system); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
