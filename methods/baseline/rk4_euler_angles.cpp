// SPDX-License-Identifier: BSD-3-Clause
//
// Baseline: the classical fourth-order method on Euler angles, R = R_z(psi) R_x(theta) R_y(phi). The last axis is the
// spin axis of the heavy top, so a fast spin is harmless; the angles are singular at theta = +-pi/2, body y vertical.
// A stage within 1/1000 of the singularity, past it, or so near that body y could reach it within the step, ends the
// step with the status chart_singularity: a long step could jump over it unnoticed and be wrong afterwards.
#include "methods/baseline/global_coordinates.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class EulerAngles final : public RotationCoordinates {
  public:
    int size() const override { return 3; }

    /// R column by column; third row (-cos theta sin phi, sin theta, cos theta cos phi), second column
    /// (-sin psi cos theta, cos psi cos theta, sin theta).
    void from_matrix(const Real* R, Real* z) const override {
        z[0] = atan2(-R[3], R[4]);
        z[1] = atan2(R[5], sqrt(R[2] * R[2] + R[8] * R[8]));
        z[2] = atan2(-R[2], R[8]);
    }

    void to_matrix(const Real* z, Real* R) const override {
        const Real cp = cos(z[0]), sp = sin(z[0]), ct = cos(z[1]), st = sin(z[1]), cf = cos(z[2]), sf = sin(z[2]);
        R[0] = cp * cf - sp * st * sf, R[1] = sp * cf + cp * st * sf, R[2] = -ct * sf;
        R[3] = -sp * ct, R[4] = cp * ct, R[5] = st;
        R[6] = cp * sf + sp * st * cf, R[7] = sp * sf - cp * st * cf, R[8] = ct * cf;
    }

    /// theta' = w_x cos phi + w_z sin phi, psi' = (w_z cos phi - w_x sin phi) / cos theta, phi' = w_y - psi' sin theta.
    bool derivative(const Real* z, const Real* w, const Real& h, Real* dz) const override {
        const Real ct = cos(z[1]), cf = cos(z[2]), sf = sin(z[2]);
        dz[0] = (w[2] * cf - w[0] * sf) / ct;
        dz[1] = w[0] * cf + w[2] * sf;
        dz[2] = w[1] - dz[0] * sin(z[1]);
        const Real swing = sqrt(w[0] * w[0] + w[2] * w[2]) * abs(h);  // of body y, which is vertical at the singularity
        return ct > max(Real(Real(1) / 1000), swing);
    }
};

}  // namespace

KREISEL_METHOD(global_rk4([](const OptionValues&) { return std::make_shared<EulerAngles>(); }),
               {.name = "baseline/rk4_euler_angles",
                .order = 4,
                .cites = {"kutta1901", "ahnert2011"},
                .summary = "classical fourth-order method on Euler angles z-x-y; their singularity ends the run",
                .equivariant = false,
                .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
