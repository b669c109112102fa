// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/rows/mesh_row.hpp"

#include "engine/reference/taylor/rows/scalars.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// The angle psi of d in the axes (e_1, e_2) of a body: psi' = (C S' - S C') / (C^2 + S^2), C = e_1 . d, S = e_2 . d.
class LineAngle {
  public:
    LineAngle(const BodySeries& body, const Mat3& axes, const JointEnds& ends)
        : e1_(body, axes.col(0)),
          e2_(body, axes.col(1)),
          C_(scalars(ends)),
          S_(C_),
          square_(C_),
          area_(C_),
          rate_(C_),
          cosine_(C_),
          sine_(C_) {}
    void follow(const JointEnds& ends, std::size_t i) {
        e1_.update(i), e2_.update(i);
        C_[i] = dot(e1_.series(), ends.d, i), S_[i] = dot(e2_.series(), ends.d, i);
        square_[i] = product(C_, C_, i) + product(S_, S_, i);
        if (i == 0) return;
        Real area = 0;
        for (std::size_t j = 0; j < i; ++j) area += C_[j] * rate(S_, i - 1 - j) - S_[j] * rate(C_, i - 1 - j);
        area_[i - 1] = area;
        rate_[i - 1] = quotient(area_, square_, rate_, i - 1);
    }
    /// Coefficient k of psi''.
    Real second(std::size_t k) const { return rate(rate_, k); }
    /// Coefficient k of the gradient in d.
    Vec3 gradient(std::size_t k) {
        cosine_[k] = quotient(C_, square_, cosine_, k), sine_[k] = quotient(S_, square_, sine_, k);
        return product(cosine_, e2_.series(), k) - product(sine_, e1_.series(), k);
    }

  private:
    Attached e1_, e2_;
    Scalars C_, S_, square_, area_, rate_, cosine_, sine_;
};

/// (z_1 psi_1 + z_2 psi_2) / z_2, up to a constant.
class MeshRow final : public DirectionRowSeries {
  public:
    MeshRow(const Joint& joint, const JointEnds& ends)
        : DirectionRowSeries(ends),
          ratio_(Real(joint.teeth[0]) / joint.teeth[1]),
          first_(ends.first, joint.axes_first, ends),
          second_(ends.second, joint.axes_second, ends),
          of_first_(ends.d),
          n_(ends.d) {}
    const Vectors* n() const override { return &n_; }
    void follow(const JointEnds& ends, std::size_t i) override { first_.follow(ends, i), second_.follow(ends, i); }
    /// Axes of the first body turn with it.
    void direct(const JointEnds& ends, std::size_t k) override {
        of_first_[k] = ratio_ * first_.gradient(k);
        n_[k] = of_first_[k] + second_.gradient(k);
        t_[k] = cross(of_first_, ends.d, k);
    }
    Real acceleration(std::size_t k) const override { return ratio_ * first_.second(k) + second_.second(k); }

  private:
    Real ratio_;
    LineAngle first_, second_;
    Vectors of_first_, n_;
};

}  // namespace

std::unique_ptr<DirectionRowSeries> mesh_row(const Joint& joint, const JointEnds& ends) {
    return std::make_unique<MeshRow>(joint, ends);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
