// SPDX-License-Identifier: BSD-3-Clause
//
// The rows of a joint and what they exert as power series in time: first those on its points, then those that compare
// directions (engine/reference/taylor/row_series.hpp). Only which rows a joint has is taken from its recipe.
#pragma once

#include "engine/reference/taylor/row_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Refers to series of bodies that outlive it.
class JointSeries {
  public:
    JointSeries(const Joint& joint, BodySeries& first, BodySeries& second);

    int rows() const { return static_cast<int>(lambda_.size()); }
    /// The length by which a row and its residuals are divided when multipliers of least norm are requested: that of
    /// the longest arm on a moving body, of the rod or the radius, or the largest radius of gyration; 1 for rows that
    /// compare directions, and between points that have none of these.
    Real scale(int row) const { return is_force(row) && length_ > 0 ? length_ : Real(1); }

    /// Whether the residual of a row is a velocity.
    bool is_velocity(int row) const { return is_force(row) && points_->is_velocity(row); }

    /// Stage 0, at time t.
    void start(const Real& t);
    /// Stage k: what the multipliers of lower coefficients exert on the bodies.
    void react(std::size_t k);
    /// Coefficients k + 2 of quantities that depend on x and R; after each change of these.
    void update(std::size_t k) { follow(k + 2); }
    /// Coefficient k of the second derivative of a row's residual, or of the first one where that is a velocity.
    Real acceleration(int row, std::size_t k) const;
    /// The wrench of a unit multiplier at the expansion point, with the opposite sign: on the first body and on the
    /// second.
    struct Wrench {
        Vec3 force, moment;
    };
    Wrench on_first(int row) const;
    Wrench on_second(int row) const;
    /// Sets lambda_k, which adds a force and a moment directly: the caller corrects the bodies.
    void set_multiplier(int row, std::size_t k, const Real& lambda);
    /// A time s after the expansion.
    Real multiplier(int row, const Real& s) const;

    BodySeries& first() const { return ends_.first; }
    BodySeries& second() const { return ends_.second; }

  private:
    void follow(std::size_t i);
    int forces() const { return points_ ? points_->rows() : 0; }
    bool is_force(int row) const { return row < forces(); }
    const Vectors& lever() const { return points_ ? points_->lever() : lever_; }
    DirectionRowSeries& direction(int row) const { return *directions_[static_cast<std::size_t>(row - forces())]; }
    /// The gradient of a row that compares directions in the points, at the expansion point.
    Vec3 thrust(int row) const { return direction(row).n() ? (*direction(row).n())[0] : Vec3(Vec3::Zero()); }

    JointEnds ends_;
    std::unique_ptr<PointRowSeries> points_;
    std::vector<std::unique_ptr<DirectionRowSeries>> directions_;
    std::vector<Scalars> lambda_;
    Vectors lever_;  // from the second mass centre to the point of the first body
    Vectors force_;  // on the second body
    Real length_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
