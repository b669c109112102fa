// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/taylor_forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Vectors vectors(const BodySeries& body) { return Vectors(body.R.size(), Vec3::Zero()); }
Scalars scalars(const BodySeries& body) { return Scalars(body.R.size(), Real(0)); }

}  // namespace

GravitySeries::GravitySeries(const Gravity& gravity, const Real& mass, BodySeries& body)
    : gravity_(gravity), mass_(mass), body_(body), factor_(scalars(body)) {}

void GravitySeries::start(const Real& t) { modulate(gravity_.amplitude, gravity_.frequency, t, factor_); }

void GravitySeries::act(std::size_t k) { body_.act(mass_ * factor_[k] * gravity_.g, Vec3::Zero(), k); }

LoadSeries::LoadSeries(const Load& load, BodySeries& body)
    : load_(load),
      body_(body),
      arm_(body, load.point),
      turned_force_(body, load.force),
      turned_torque_(body, load.torque),
      factor_(scalars(body)),
      force_(vectors(body)) {}

void LoadSeries::start(const Real& t) { modulate(load_.amplitude, load_.frequency, t, factor_); }

void LoadSeries::act(std::size_t k) {
    for (Attached* attached : {&arm_, &turned_force_, &turned_torque_}) attached->update(k);
    const bool turns = load_.axes == Load::Axes::body;
    const auto modulated = [&](const Vec3& fixed, const Attached& turned) -> Vec3 {
        return turns ? product(factor_, turned.series(), k) : Vec3(factor_[k] * fixed);
    };
    force_[k] = modulated(load_.force, turned_force_);
    body_.act(force_[k], cross(arm_.series(), force_, k) + modulated(load_.torque, turned_torque_), k);
}

SpringSeries::SpringSeries(const Spring& spring, BodySeries& first, BodySeries& second)
    : spring_(spring),
      first_(first),
      second_(second),
      arm_first_(first, spring.r_first),
      arm_second_(second, spring.r_second),
      d_(vectors(first)),
      scaled_(d_),
      tension_(d_),
      square_(scalars(first)),
      length_(square_),
      size_(square_),
      stretches_(spring.length != 0 || spring.damping != 0) {}

void SpringSeries::update(std::size_t i) {
    arm_first_.update(i), arm_second_.update(i);
    d_[i] = second_.x[i] + arm_second_[i] - first_.x[i] - arm_first_[i];
    if (!stretches_) return;  // the points may meet
    square_[i] = dot(d_, d_, i);
    length_[i] = square_root(square_, length_, i);
}

void SpringSeries::start(const Real&) { update(0); }

void SpringSeries::act(std::size_t k) {
    update(k + 1);
    tension_[k] = spring_.stiffness * d_[k];
    if (stretches_) {
        size_[k] = spring_.stiffness * length_[k] + spring_.damping * rate(length_, k);
        if (k == 0) size_[k] -= spring_.stiffness * spring_.length;
        scaled_[k] = product(size_, d_, k);
        tension_[k] = quotient(scaled_, length_, tension_, k);
    }
    first_.act(tension_[k], cross(arm_first_.series(), tension_, k), k);
    second_.act(-tension_[k], -cross(arm_second_.series(), tension_, k), k);
}

TorsionSpringSeries::TorsionSpringSeries(const TorsionSpring& spring, BodySeries& first, BodySeries& second)
    : spring_(spring),
      first_(first),
      second_(second),
      f1_(first, spring.axes_first.col(0)),
      f2_(first, spring.axes_first.col(1)),
      u_(second, spring.axes_second.col(0)),
      x_(scalars(first)),
      y_(x_),
      x_rate_(x_),
      y_rate_(x_),
      square_(x_),
      area_(x_),
      theta_(x_),
      theta_rate_(x_),
      size_(x_),
      across_(vectors(first)),
      moment_(across_),
      gradient_(across_),
      expected_(2 * pi() * Real(spring.turns)) {}

void TorsionSpringSeries::update(std::size_t i) {
    f1_.update(i), f2_.update(i), u_.update(i);
    x_[i] = dot(u_.series(), f1_.series(), i), y_[i] = dot(u_.series(), f2_.series(), i);
}

void TorsionSpringSeries::start(const Real&) {
    using std::floor;
    update(0);
    const Real principal = atan2(y_[0], x_[0]), turn = 2 * pi();
    theta_[0] = principal + turn * floor(Real((expected_ - principal) / turn + Real(1) / 2));
}

void TorsionSpringSeries::move_on(const Real& s) { expected_ = value(theta_, s); }

bool TorsionSpringSeries::has_parted(const Real& s) const {
    const Real x = value(x_, s), y = value(y_, s);
    return 4 * (x * x + y * y) < 1;
}

void TorsionSpringSeries::act(std::size_t k) {
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

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
