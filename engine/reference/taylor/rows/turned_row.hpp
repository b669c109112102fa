// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "engine/reference/taylor/rows/scalars.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// tan = (a . b_2) / (a . b_1) of an axis a that has turned by f in the first body, a = cos f a1 + sin f a2: where it
/// vanishes its gradient is that of the angle.
class TurnedRow : public DirectionRowSeries {
  public:
    TurnedRow(const Joint& joint, const Vec3& a1, const Vec3& a2, const JointEnds& ends)
        : DirectionRowSeries(ends),
          f_(scalars(ends)),
          a1_(ends.first, a1),
          a2_(ends.first, a2),
          b1_(ends.second, joint.axes_second.col(0)),
          b2_(ends.second, joint.axes_second.col(1)),
          cosine_(f_),
          sine_(f_),
          above_(f_),
          below_(f_),
          tangent_(f_),
          growth_(f_),
          slope_(f_),
          a_(ends.d),
          normal_(a_),
          couple_(a_) {}
    void follow(const JointEnds&, std::size_t i) override {
        a1_.update(i), a2_.update(i), b1_.update(i), b2_.update(i);
        turn(i);
        a_[i] = product(cosine_, a1_.series(), i) + product(sine_, a2_.series(), i);
        above_[i] = dot(a_, b2_.series(), i), below_[i] = dot(a_, b1_.series(), i);
        tangent_[i] = quotient(above_, below_, tangent_, i);
    }
    void direct(const JointEnds&, std::size_t k) override {
        normal_[k] = cross(a_, b2_.series(), k);
        t_[k] = couple_[k] = quotient(normal_, below_, couple_, k);
    }
    Real acceleration(std::size_t k) const override { return twice(k) * tangent_[k + 2]; }

  protected:
    Scalars f_;
    /// Coefficient k of the derivative of the residual in f, after those before it.
    Real slope(std::size_t k) {
        Real sum = 0;
        for (std::size_t j = 0; j <= k; ++j)
            sum += (product(cosine_, a2_.series(), j) - product(sine_, a1_.series(), j)).dot(b2_[k - j]);
        growth_[k] = sum;
        return slope_[k] = quotient(growth_, below_, slope_, k);
    }

  private:
    /// cos' = -sin f', sin' = cos f'.
    void turn(std::size_t i) {
        if (i == 0) {
            cosine_[0] = cos(f_[0]), sine_[0] = sin(f_[0]);
            return;
        }
        Real c = 0, s = 0;
        for (std::size_t j = 1; j <= i; ++j) {
            const Real rate = real(j) * f_[j];
            c -= rate * sine_[i - j], s += rate * cosine_[i - j];
        }
        cosine_[i] = c / real(i), sine_[i] = s / real(i);
    }

    Attached a1_, a2_, b1_, b2_;
    Scalars cosine_, sine_, above_, below_, tangent_, growth_, slope_;
    Vectors a_, normal_, couple_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
