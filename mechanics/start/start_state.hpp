// SPDX-License-Identifier: BSD-3-Clause
//
// A model's start in the coordinates of SO3xR3, with the residuals of its rows and the rates of its motion.
#pragma once

#include <memory>
#include <vector>

#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class StartState {
  public:
    static constexpr const char* coordinates = "SO3xR3";

    /// The model outlives this object.
    explicit StartState(const Model& model);

    const Model& model() const { return model_; }
    System& system() { return *system_; }
    Eigen::Index rows() const { return m_; }
    Eigen::Index velocity_coordinates() const { return n_; }
    Real* q() { return y_.data(); }
    Real* v() { return system_->v(y_.data()); }
    Eigen::Map<VecX> velocities() { return Eigen::Map<VecX>(v(), n_); }

    VecX position_residual();                     ///< Phi, zero in rows without a position level
    VecX velocity_residual();                     ///< C v + b
    VecX position_terms();                        ///< sum of the sizes of the terms of each row of Phi
    MatX jacobian();                              ///< C
    const VecX& scale() const { return scale_; }  ///< of each row (System::row_scale)
    /// Norm of a residual, each row divided by its scale.
    Real size_of(const VecX& residual) const { return residual.cwiseQuotient(scale_).norm(); }

    const Real& size() const { return size_; }    ///< of the mechanism (m)
    const Real& place() const { return place_; }  ///< its distance from the origin (m)
    /// The largest of |omega| and |v| over the extent (1/s).
    Real speed();
    /// Rate of the motion (1/s): the largest of |omega|, |v| over the extent, the rates of driven rods and of
    /// prescribed coordinates, and those that forces cause from rest, sqrt(|force| / (mass extent)) and
    /// sqrt(|torque| / moment of inertia).
    Real rate();
    /// What speeds and distances from the origin contribute to the round-off of velocity rows (m/s).
    Real speed_round_off() { return largest_part(0) + largest_part(3) * place_; }

    /// Rows of C that are lengths.
    std::vector<Eigen::Index> length_rows() const;
    /// Calls f(joint, its row, row of C) for all rows.
    template <class F>
    void each_row(F f) const {
        Eigen::Index position = 0, velocity = system_->position_constraints();
        for (std::size_t j = 0; j < model_.joints.size(); ++j)
            for (int k = 0; k < rows_of(model_.joints[j].type); ++k)
                f(j, k, k < position_rows_of(model_.joints[j].type) ? position++ : velocity++);
    }

  private:
    /// Largest |v| (part 0) or |omega| (part 3) of a body.
    Real largest_part(Eigen::Index part);

    const Model& model_;
    std::unique_ptr<System> system_;
    std::vector<Real> y_;
    Eigen::Index m_, n_;
    Real size_, place_;
    VecX scale_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
