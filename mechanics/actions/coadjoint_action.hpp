// SPDX-License-Identifier: BSD-3-Clause
//
// States (R, omega) of a body with the inertia J_O about its fixed point, moved as elements (R, m = J_O omega) of
// T*SO(3) (lie/cotangent_so3.hpp): y' = y z with z = (omega, J_O^{-1} tau) is
//   R' = R hat(omega),   m' = ad*_omega m + tau = m x omega + tau,
// tau the torque in body axes [hairer2006, Sec. VII.5]. Where it vanishes, every product of exponentials of such z
// keeps R m, the momentum in space, and with it |m|, the Casimir of so(3)*, to round-off.
#pragma once

#include "lie/cotangent_so3.hpp"
#include "lie/power.hpp"
#include "mechanics/actions/state_action.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class CoadjointAction : public StateAction {
  public:
    /// J_O about the fixed point, and its inverse.
    CoadjointAction(const Mat3& J_O, const Mat3& J_O_inverse);
    /// v' less ad*_u m: (u, omega') is (u, omega' - J_O^{-1} (m x u)).
    void from_tangent(const Real* y, Real* z) const override;
    void to_tangent(const Real* y, Real* z) const override;

    void identity(Real* y) const override;
    void multiply(const Real* a, const Real* b, Real* out) const override;
    void inverse(const Real* a, Real* out) const override;
    void log(const Real* y, Real* z) const override;
    void bracket(const Real* u, const Real* z, Real* out) const override;
    void Ad(const Real* y, const Real* z, Real* out) const override;
    void coAd(const Real* y, const Real* p, Real* out) const override;
    void dexp(const Real* u, const Real* z, Real* out) const override;
    void append_exp(const Real* y, const Real* u, Real* out) const override;
    void append_cay(const Real* y, const Real* u, Real* out) const override;
    bool in_exp_chart(const Real* u) const override;
    bool dexpinv_left(const Real* u, const Real* z, Real* out) const override;
    void dcayinv_left(const Real* u, const Real* z, Real* out) const override;
    bool dexpinv_left_transpose(const Real* u, const Real* p, Real* out) const override;
    void dcayinv_left_transpose(const Real* u, const Real* p, Real* out) const override;
    Real orthogonality_defect(const Real* y) const override;

  private:
    Power<CotangentSO3> group_;
    Mat3 J_, J_inverse_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
