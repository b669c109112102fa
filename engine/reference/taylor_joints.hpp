// SPDX-License-Identifier: BSD-3-Clause
//
// The rows of a joint and what they exert as power series in time. The rows are those that
// mechanics/joints/joint_rows.hpp documents, written down a second time: a row says that its residual vanishes (a
// length, a cosine, or for two rows of a rolling joint a velocity), and its multiplier lambda exerts on the first body
//   -lambda n at the joint's point and the couple -lambda t,
// the opposite on the second, where n and t are the gradients of the residual. Accelerations enter through coefficients
// of x and R only: nothing is differentiated by hand.
#pragma once

#include <initializer_list>
#include <utility>

#include "engine/reference/taylor_bodies.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Refers to series of bodies that outlive it.
class JointSeries {
  public:
    JointSeries(const Joint& joint, BodySeries& first, BodySeries& second);

    int rows() const { return static_cast<int>(forces_.size() + turns_.size()); }
    /// The length by which a row and its residuals are divided when multipliers of least norm are requested: that of
    /// the longest arm on a moving body, of the rod or the radius, or the largest radius of gyration; 1 for rows that
    /// compare directions, and between points that have none of these.
    Real scale(int row) const;

    /// Whether the residual of a row is a velocity.
    bool is_velocity(int row) const { return hold_ == Hold::contact && row > 0; }

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
    const Real& multiplier(int row) const { return lambda_[static_cast<std::size_t>(row)][0]; }

    BodySeries& first() const { return first_; }
    BodySeries& second() const { return second_; }

  private:
    /// Rows on the points: no difference, none along axes of the second body, a length, or a disk's contact.
    enum class Hold { coincidence, along, distance, contact };
    struct ForceRow {
        Vec3 axis;  ///< n where it is fixed in space or, of `along`, in the second body
        Vectors n;
    };
    /// a . b = 0, t = a x b.
    struct TurnRow {
        Attached a, b;
        Vectors t;
    };

    void hold(Hold how, std::initializer_list<int> axes);
    void align(std::initializer_list<std::pair<int, int>> axes);
    void add_rows();
    void follow(std::size_t i);
    void follow_contact(std::size_t i);
    bool is_force(int row) const { return row < static_cast<int>(forces_.size()); }
    const ForceRow& force_row(int row) const { return forces_[static_cast<std::size_t>(row)]; }
    const TurnRow& turn_row(int row) const { return turns_[static_cast<std::size_t>(row) - forces_.size()]; }

    Joint joint_;
    BodySeries &first_, &second_;
    Hold hold_ = Hold::coincidence;
    std::vector<ForceRow> forces_;
    std::vector<TurnRow> turns_;
    std::vector<Scalars> lambda_;
    Attached arm_first_, arm_second_;
    Vectors d_, lever_, force_;      // lever: from the second mass centre to where the force acts
    Scalars square_, length_, law_;  // |d|^2 and |d|, or |s|^2 and |s|; law: the prescribed length
    Attached disk_;                  // the disk's axis
    Scalars cosine_;                 // of that and the plane's normal
    Vectors s_, unit_, omega_;       // s, -s/|s|, and omega in space axes, of the disk
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
