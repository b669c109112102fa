// SPDX-License-Identifier: BSD-3-Clause
//
// Where the rows of joints stand among those of C: joints in the order of the model, rows without a position level
// after all others.
#pragma once

#include <vector>

#include "mechanics/joints/joint_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class RowPlaces {
  public:
    explicit RowPlaces(const Model& model) {
        for (const Joint& joint : model.joints) {
            joints_.push_back({rows_of(joint.type), position_rows_of(joint.type), position_rows_, 0});
            position_rows_ += joints_.back().position;
        }
        rows_ = position_rows_;
        for (Place& place : joints_) {
            place.first_velocity = rows_;
            rows_ += place.all - place.position;
        }
    }
    int rows() const { return rows_; }                    ///< m
    int position_rows() const { return position_rows_; }  ///< those of Phi, the first of all
    std::size_t joints() const { return joints_.size(); }
    int rows_of_joint(std::size_t joint) const { return joints_[joint].all; }
    int position_rows_of_joint(std::size_t joint) const { return joints_[joint].position; }
    /// Row of C of row k of a joint.
    int row(std::size_t joint, int k) const {
        const auto& [all, position, first, first_velocity] = joints_[joint];
        return k < position ? first + k : first_velocity + k - position;
    }

  private:
    struct Place {
        int all, position;          // rows of the joint
        int first, first_velocity;  // where its position rows and its others begin
    };
    std::vector<Place> joints_;
    int rows_ = 0, position_rows_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
