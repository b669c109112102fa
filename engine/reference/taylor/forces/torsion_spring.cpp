// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/force_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// With u = R_second e_1 and x, y its components along the first two axes of the first frame,
///   theta' = (x y' - y x') / (x^2 + y^2),   gradient = u x (x f_2 - y f_1) / (x^2 + y^2).
/// theta_0 is atan2(y, x) plus the full turns that bring it nearest to the angle at the end of the last series.
class TorsionSpringSeries final : public ForceSeries {
  public:
    TorsionSpringSeries(const TorsionSpring& spring, const BodyAt& at)
        : spring_(spring),
          first_(at(spring.first)),
          second_(at(spring.second)),
          f1_(first_, spring.axes_first.col(0)),
          f2_(first_, spring.axes_first.col(1)),
          u_(second_, spring.axes_second.col(0)),
          x_(scalars(first_)),
          y_(x_),
          x_rate_(x_),
          y_rate_(x_),
          square_(x_),
          area_(x_),
          theta_(x_),
          theta_rate_(x_),
          size_(x_),
          across_(vectors(first_)),
          moment_(across_),
          gradient_(across_),
          expected_(2 * pi() * Real(spring.turns)) {}

    void start(const Real&) override {
        using std::floor;
        update(0);
        const Real principal = atan2(y_[0], x_[0]), turn = 2 * pi();
        theta_[0] = principal + turn * floor(Real((expected_ - principal) / turn + Real(1) / 2));
    }

    void act(std::size_t k) override {
        update(k + 1);
        x_rate_[k] = rate(x_, k), y_rate_[k] = rate(y_, k);
        square_[k] = product(x_, x_, k) + product(y_, y_, k);
        area_[k] = product(x_, y_rate_, k) - product(y_, x_rate_, k);
        theta_rate_[k] = quotient(area_, square_, theta_rate_, k);
        theta_[k + 1] = theta_rate_[k] / real(k + 1);
        across_[k] = product(x_, f2_.series(), k) - product(y_, f1_.series(), k);
        moment_[k] = cross(u_.series(), across_, k);
        gradient_[k] = quotient(moment_, square_, gradient_, k);
        size_[k] = -spring_.stiffness * theta_[k] - spring_.damping * theta_rate_[k];
        if (k == 0) size_[k] += spring_.stiffness * spring_.angle;
        const Vec3 torque = product(size_, gradient_, k);
        first_.act(Vec3::Zero(), -torque, k), second_.act(Vec3::Zero(), torque, k);
    }

    void move_on(const Real& s) override { expected_ = value(theta_, s); }

    /// The angle winds about a pose where it is undefined.
    bool has_parted(const Real& s) const override {
        const Real x = value(x_, s), y = value(y_, s);
        return 4 * (x * x + y * y) < 1;
    }

  private:
    void update(std::size_t i) {
        f1_.update(i), f2_.update(i), u_.update(i);
        x_[i] = dot(u_.series(), f1_.series(), i), y_[i] = dot(u_.series(), f2_.series(), i);
    }

    TorsionSpring spring_;
    BodySeries &first_, &second_;
    Attached f1_, f2_, u_;
    Scalars x_, y_, x_rate_, y_rate_, square_, area_, theta_, theta_rate_, size_;
    Vectors across_, moment_, gradient_;
    Real expected_;
};

const SeriesRegistration<TorsionSpring, TorsionSpringSeries> torsion_spring_series;

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
