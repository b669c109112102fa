// SPDX-License-Identifier: BSD-3-Clause
//
// Baseline: the classical fourth-order method on quaternions, q' = 1/2 q (0, omega). R = R(q) is the quadratic form,
// which is |q|^2 times a rotation when the norm drifts; option `renormalise` divides q by its norm after each step.
#include "methods/baseline/quaternion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class NormalisedQuaternion final : public Quaternion {
  public:
    explicit NormalisedQuaternion(bool renormalise) : renormalise_(renormalise) {}

    void finish(Real* q) const override {
        if (!renormalise_) return;
        const Real norm = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int i = 0; i < 4; ++i) q[i] /= norm;
    }

  private:
    bool renormalise_;
};

}  // namespace

KREISEL_METHOD(global_rk4(
                   [](const OptionValues& options) {
                       return std::make_shared<NormalisedQuaternion>(std::get<bool>(options.at("renormalise")));
                   },
                   {{.name = "renormalise", .summary = "divide q by its norm after each step", .standard = true}}),
               {.name = "baseline/rk4_quaternion",
                .order = 4,
                .cites = {"kutta1901", "ahnert2011"},
                .summary = "classical fourth-order method on quaternions, no group",
                .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
