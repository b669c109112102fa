// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/force_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// The frames are three vectors each, attached to their bodies: e_i of the first and n_i of the second. The place of
/// the second in the first has the coordinates p_i = e_i . d, and the angles follow from their rates: with the angular
/// velocity w of the second body relative to the first, s = e_1 . n_3, c^2 = 1 - s^2 and m = n_3 x e_1,
///   c^2 q_1' = (e_1 - s n_3) . w,   c q_2' = m . w,   c^2 q_3' = (n_3 - s e_1) . w.
/// A force F on the second body at its place has the power F . (d' - w_first x d), whose components along e_i are p_i'.
class BushingSeries final : public ForceSeries {
  public:
    BushingSeries(const Bushing& bushing, const BodyAt& at)
        : bushing_(bushing),
          first_(at(bushing.first)),
          second_(at(bushing.second)),
          e_{axis(first_, bushing.axes_first, 0), axis(first_, bushing.axes_first, 1),
             axis(first_, bushing.axes_first, 2)},
          n_{axis(second_, bushing.axes_second, 0), axis(second_, bushing.axes_second, 1),
             axis(second_, bushing.axes_second, 2)},
          arm_first_(first_, bushing.r_first),
          arm_second_(second_, bushing.r_second),
          arm_(vectors(first_)),
          d_(arm_),
          turning_(arm_),
          force_(arm_),
          sine_(scalars(first_)),
          square_(sine_),
          cosine_(sine_),
          p_{sine_, sine_, sine_},
          q_(p_),
          q_rate_(p_),
          work_(p_),
          size_(p_),
          gradient_{arm_, arm_, arm_},
          above_(gradient_) {}

    void start(const Real&) override {
        update(0);
        const auto dot0 = [&](std::size_t i, std::size_t k) -> Real { return e_[i][0].dot(n_[k][0]); };
        q_[0][0] = atan2(-dot0(1, 2), dot0(2, 2));
        q_[1][0] = atan2(dot0(0, 2), sqrt(Real(1 - dot0(0, 2) * dot0(0, 2))));
        q_[2][0] = atan2(-dot0(0, 1), dot0(0, 0));
    }

    void act(std::size_t k) override {
        update(k + 1);
        turning_[k] = product(second_.R, second_.omega, k) - product(first_.R, first_.omega, k);
        find_gradients(k);
        Vec3 torque = Vec3::Zero();
        force_[k].setZero();
        for (std::size_t i = 0; i < 3; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            q_rate_[i][k] = dot(gradient_[i], turning_, k);
            q_[i][k + 1] = q_rate_[i][k] / real(k + 1);
            work_[i][k] = -bushing_.stiffness[0][row] * p_[i][k] - bushing_.damping[0][row] * rate(p_[i], k);
            size_[i][k] = -bushing_.stiffness[1][row] * q_[i][k] - bushing_.damping[1][row] * q_rate_[i][k];
            force_[k] += product(work_[i], e_[i].series(), k);
            torque += product(size_[i], gradient_[i], k);
        }
        first_.act(-force_[k], -cross(arm_, force_, k) - torque, k);
        second_.act(force_[k], cross(arm_second_.series(), force_, k) + torque, k);
    }

  private:
    static Attached axis(const BodySeries& body, const Mat3& axes, Eigen::Index i) { return {body, axes.col(i)}; }

    void update(std::size_t i) {
        for (Attached& one : e_) one.update(i);
        for (Attached& one : n_) one.update(i);
        arm_first_.update(i), arm_second_.update(i);
        arm_[i] = second_.x[i] + arm_second_[i] - first_.x[i];
        d_[i] = arm_[i] - arm_first_[i];
        for (std::size_t k = 0; k < 3; ++k) p_[k][i] = dot(e_[k].series(), d_, i);
    }

    void find_gradients(std::size_t k) {
        const Vectors &e = e_[0].series(), &n = n_[2].series();
        sine_[k] = dot(e, n, k);
        square_[k] = (k == 0 ? Real(1) : Real(0)) - product(sine_, sine_, k);
        cosine_[k] = square_root(square_, cosine_, k);
        above_[0][k] = e[k] - product(sine_, n, k);
        above_[1][k] = cross(n, e, k);
        above_[2][k] = n[k] - product(sine_, e, k);
        for (std::size_t i = 0; i < 3; i += 2) gradient_[i][k] = quotient(above_[i], square_, gradient_[i], k);
        gradient_[1][k] = quotient(above_[1], cosine_, gradient_[1], k);
    }

    Bushing bushing_;
    BodySeries &first_, &second_;
    std::array<Attached, 3> e_, n_;
    Attached arm_first_, arm_second_;
    Vectors arm_, d_, turning_, force_;  // arm: from the mass centre of the first to the second frame
    Scalars sine_, square_, cosine_;
    std::array<Scalars, 3> p_, q_, q_rate_, work_, size_;
    std::array<Vectors, 3> gradient_, above_;  // gradient: above over c^2 or c
};

const SeriesRegistration<Bushing, BushingSeries> bushing_series;

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
