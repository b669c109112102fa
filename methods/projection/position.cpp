// SPDX-License-Identifier: BSD-3-Clause
#include "methods/projection/gauss_newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class PositionProjection final : public GaussNewtonProjection {
  public:
    using GaussNewtonProjection::GaussNewtonProjection;
    Status project(const Real& t, Real* y) override { return project_position(t, y); }
};

}  // namespace

KREISEL_PROJECTION(
    {.name = "position",
     .summary = "positions onto Phi = 0, mass-weighted Gauss-Newton with group updates; velocities as they are",
     .cites = {"eich1993"},
     .positions = true},
    [](System& system, const OptionValues&) { return std::make_unique<PositionProjection>(system); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
