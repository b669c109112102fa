// SPDX-License-Identifier: BSD-3-Clause
//
// Forces and moments of gravity, loads and springs as power series in time, all in space axes; their laws are those of
// mechanics/model/model.hpp.
#pragma once

#include "engine/reference/taylor/taylor_bodies.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// What acts on bodies; refers to series of bodies that outlive it.
class ForceSeries {
  public:
    virtual ~ForceSeries() = default;
    /// At the expansion point, at time t.
    virtual void start(const Real& /*t*/) {}
    /// Adds coefficient k to the bodies it acts on.
    virtual void act(std::size_t k) = 0;
    /// Before the next expansion, at a time s after the last one: keeps the state that poses and velocities do not
    /// contain.
    virtual void move_on(const Real& /*s*/) {}
    /// Whether the force is not defined a time s after the expansion point.
    virtual bool has_parted(const Real& /*s*/) const { return false; }
};

class GravitySeries final : public ForceSeries {
  public:
    GravitySeries(const Gravity& gravity, const Real& mass, BodySeries& body);
    void start(const Real& t) override;
    void act(std::size_t k) override;

  private:
    Gravity gravity_;
    Real mass_;
    BodySeries& body_;
    Scalars factor_;
};

class LoadSeries final : public ForceSeries {
  public:
    LoadSeries(const Load& load, BodySeries& body);
    void start(const Real& t) override;
    void act(std::size_t k) override;

  private:
    Load load_;
    BodySeries& body_;
    Attached arm_, turned_force_, turned_torque_;
    Scalars factor_;
    Vectors force_;
};

/// With d from the first point to the second and l = |d|: (stiffness (l - length) + damping l') d / l on the first.
class SpringSeries final : public ForceSeries {
  public:
    SpringSeries(const Spring& spring, BodySeries& first, BodySeries& second);
    void start(const Real& t) override;
    void act(std::size_t k) override;

  private:
    void update(std::size_t i);

    Spring spring_;
    BodySeries &first_, &second_;
    Attached arm_first_, arm_second_;
    Vectors d_, scaled_, tension_;  // scaled: l' is a Cauchy product, and l tension a quotient
    Scalars square_, length_, size_;
    bool stretches_;
};

/// With u = R_second e_1 and x, y its components along the first two axes of the first frame,
///   theta' = (x y' - y x') / (x^2 + y^2),   gradient = u x (x f_2 - y f_1) / (x^2 + y^2).
/// theta_0 is atan2(y, x) plus the full turns that bring it nearest to the angle at the end of the last series.
class TorsionSpringSeries final : public ForceSeries {
  public:
    TorsionSpringSeries(const TorsionSpring& spring, BodySeries& first, BodySeries& second);
    void start(const Real& t) override;
    void act(std::size_t k) override;
    void move_on(const Real& s) override;
    /// The angle winds about a pose where it is undefined.
    bool has_parted(const Real& s) const override;

  private:
    void update(std::size_t i);

    TorsionSpring spring_;
    BodySeries &first_, &second_;
    Attached f1_, f2_, u_;
    Scalars x_, y_, x_rate_, y_rate_, square_, area_, theta_, theta_rate_, size_;
    Vectors across_, moment_, gradient_;
    Real expected_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
