// SPDX-License-Identifier: BSD-3-Clause
//
// Baseline: the classical fourth-order method on the nine entries of R, R' = R hat(omega): R leaves SO(3).
#include <algorithm>

#include "methods/baseline/global_coordinates.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class MatrixEntries final : public RotationCoordinates {
  public:
    int size() const override { return 9; }
    void from_matrix(const Real* R, Real* z) const override { std::copy_n(R, 9, z); }
    void to_matrix(const Real* z, Real* R) const override { std::copy_n(z, 9, R); }
    /// Columns of R hat(omega): (w_z R_2 - w_y R_3, w_x R_3 - w_z R_1, w_y R_1 - w_x R_2).
    bool derivative(const Real* R, const Real* w, const Real& /*h*/, Real* dR) const override {
        for (int i = 0; i < 3; ++i) {
            dR[i] = w[2] * R[3 + i] - w[1] * R[6 + i];
            dR[3 + i] = w[0] * R[6 + i] - w[2] * R[i];
            dR[6 + i] = w[1] * R[i] - w[0] * R[3 + i];
        }
        return true;
    }
};

}  // namespace

KREISEL_METHOD(global_rk4([](const OptionValues&) { return std::make_shared<MatrixEntries>(); }),
               {.name = "baseline/rk4_matrix",
                .order = 4,
                .cites = {"kutta1901", "ahnert2011"},
                .summary = "classical fourth-order method on the entries of R, which leaves SO(3)",
                .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
