// SPDX-License-Identifier: BSD-3-Clause
//
// C of a model with joints of any kind, at one configuration, as what it is made of: the wrenches W of the rows on each
// body (columns of JointRows::first and second), in body axes. Rows stand joint by joint.
#pragma once

#include <string>
#include <vector>

#include "mechanics/joints/joint_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A body with what one evaluation computes for it: a = (A, omega'), A = R^T x''. Masses, forces and torques are in
/// mass units.
struct BodyNode {
    Real inverse_mass;
    Mat3 J, J_inverse;
    Motion motion;
    Vec6 a = Vec6::Zero();
    /// M^{-1} (force, torque).
    Vec6 mobility(const Vec6& wrench) const {
        Vec6 acceleration;
        acceleration << inverse_mass * wrench.head<3>(), J_inverse * wrench.tail<3>();
        return acceleration;
    }
};

class ConstraintMatrix {
  public:
    /// A joint on a moving body: W and M^{-1} W.
    struct End {
        std::size_t joint, body;
        const Mat6* W;
        Mat6 mobility = Mat6::Zero();
    };

    /// The model outlives this.
    explicit ConstraintMatrix(const Model& model);
    ConstraintMatrix(const ConstraintMatrix&) = delete;
    ConstraintMatrix& operator=(const ConstraintMatrix&) = delete;

    std::size_t bodies() const { return model_.bodies.size(); }
    std::size_t joints() const { return rows_.size(); }
    int rows(std::size_t joint) const { return count_[joint]; }
    Eigen::Index at(std::size_t joint, int k) const { return first_[joint] + k; }  ///< row k of a joint
    int size() const { return size_; }                                             ///< all rows
    const std::vector<End>& ends() const { return ends_; }
    std::string name_of_row(std::size_t joint, int k) const;
    /// The names of the rows for which chosen(row) holds, separated by commas.
    template <class Chosen>
    std::string names_of_rows(Chosen chosen) const;

    /// W at time t for the motions of the bodies.
    void evaluate(const Real& t, const std::vector<BodyNode>& bodies);
    /// M^{-1} W of the rows evaluated last.
    void evaluate_mobilities(const std::vector<BodyNode>& bodies);
    /// product += C a.
    void apply(const std::vector<BodyNode>& bodies, VecX& product) const;
    /// a -= M^{-1} C^T lambda.
    void subtract_reaction(const VecX& lambda, std::vector<BodyNode>& bodies) const;
    /// d/dt (C v + b) less C v'.
    void acceleration_bias(VecX& bias) const;
    /// C^T as a dense matrix, each wrench on a body as weigh(body, wrench) has it.
    template <class Weigh>
    MatX transpose(Weigh weigh) const;

  private:
    const Model& model_;
    std::vector<JointRows> rows_;
    std::vector<int> count_, first_;  // rows of each joint
    int size_ = 0;
    std::vector<End> ends_;
};

template <class Chosen>
std::string ConstraintMatrix::names_of_rows(Chosen chosen) const {
    std::string names;
    for (std::size_t j = 0; j < joints(); ++j)
        for (int k = 0; k < rows(j); ++k)
            if (chosen(at(j, k))) names += (names.empty() ? "" : ", ") + name_of_row(j, k);
    return names;
}

template <class Weigh>
MatX ConstraintMatrix::transpose(Weigh weigh) const {
    MatX A = MatX::Zero(6 * static_cast<Eigen::Index>(bodies()), size_);
    for (const End& end : ends_)
        for (int k = 0; k < rows(end.joint); ++k)
            A.block<6, 1>(6 * static_cast<Eigen::Index>(end.body), at(end.joint, k)) +=
                weigh(end.body, Vec6(end.W->col(k)));
    return A;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
