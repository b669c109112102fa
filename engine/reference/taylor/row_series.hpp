// SPDX-License-Identifier: BSD-3-Clause
//
// The primitive rows of joints (mechanics/parts/joint_type.hpp) as power series in time, a class each, derived here a
// second time. The multiplier lambda of a row exerts on the first body
//   -lambda n at the joint's point and the couple -lambda t,
// the opposite on the second, where n and t are the gradients of the row's residual. Accelerations enter through
// coefficients of x and R only: nothing is differentiated by hand.
#pragma once

#include <memory>

#include "engine/reference/taylor/taylor_bodies.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The points of a joint on its bodies, and d from the second to the first.
struct JointEnds {
    JointEnds(const Joint& joint, BodySeries& first_body, BodySeries& second_body);
    /// Coefficient i, once those of x and R are known.
    void follow(std::size_t i);

    BodySeries &first, &second;
    Attached arm_first, arm_second;
    Vectors d;
};

/// The rows of a joint on its points, all of one primitive.
class PointRowSeries {
  public:
    virtual ~PointRowSeries() = default;
    int rows() const { return static_cast<int>(n_.size()); }
    const Vectors& n(int row) const { return n_[static_cast<std::size_t>(row)]; }
    /// From the second mass centre to where the force acts.
    const Vectors& lever() const { return lever_; }
    /// Whether n depends on time.
    virtual bool turns() const { return false; }
    /// Whether the residual of a row is a velocity.
    virtual bool is_velocity(int /*row*/) const { return false; }
    /// At the expansion point, at time t.
    virtual void start(const Real& /*t*/) {}
    /// Coefficient i of what depends on x and R.
    virtual void follow(const JointEnds& ends, std::size_t i) = 0;
    /// Coefficient k of an n that does not follow from R.
    virtual void direct(const JointEnds& /*ends*/, std::size_t /*k*/) {}
    /// Coefficient k of the second derivative of a row's residual, or of the first one where that is a velocity.
    virtual Real acceleration(const JointEnds& ends, int row, std::size_t k) const = 0;

  protected:
    explicit PointRowSeries(const JointEnds& ends) : lever_(ends.d) {}
    std::vector<Vectors> n_;
    Vectors lever_;
};

/// Those of a joint; null if it has none.
std::unique_ptr<PointRowSeries> point_rows(const Joint& joint, const JointEnds& ends);

/// A row that compares directions; t is the gradient of its residual in the rotation of the first body.
class DirectionRowSeries {
  public:
    virtual ~DirectionRowSeries() = default;
    const Vectors& t() const { return t_; }
    /// The gradient in d, whose force acts at the point of the first body; null if there is none.
    virtual const Vectors* n() const { return nullptr; }
    /// At the expansion point, at time t.
    virtual void start(const Real& /*t*/) {}
    /// Coefficient i of what depends on x and R.
    virtual void follow(const JointEnds& ends, std::size_t i) = 0;
    /// Coefficient k of the gradients.
    virtual void direct(const JointEnds& ends, std::size_t k) = 0;
    /// Coefficient k of the second derivative of the residual.
    virtual Real acceleration(std::size_t k) const = 0;

  protected:
    explicit DirectionRowSeries(const JointEnds& ends) : t_(ends.d) {}
    Vectors t_;
};

/// That of a row; null if it compares no directions.
std::unique_ptr<DirectionRowSeries> direction_row(const Joint& joint, const JointRow& row, const JointEnds& ends);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
