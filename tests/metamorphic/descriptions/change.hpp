// SPDX-License-Identifier: BSD-3-Clause
//
// The same motion in another description: in other units, from another place and direction of space or its mirror
// image, in other axes of the bodies, in another order.
#pragma once

#include "tests/metamorphic/models/motion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

/// x -> length Q x + shift and t -> time t, masses times `mass`; Q is `space`, orthogonal with det Q = +-1. Components
/// in the axes of body i change by the orthogonal `axes[i]`, of the same determinant. Polar vectors follow, axial ones
/// (omega, torque) get the factor det Q too, and every other datum the factor of its unit. An empty list: unchanged.
struct Change {
    Real length = 1, mass = 1, time = 1;
    Mat3 space = Mat3::Identity();
    Vec3 shift = Vec3::Zero();
    std::vector<Mat3> axes = {};
    std::vector<int> bodies = {}, joints = {};  ///< where body i, joint j stands afterwards
    std::vector<bool> reversed = {};            ///< joints whose bodies are exchanged, by the old order
    std::string prefix = {};                    ///< before the names of the bodies

    bool mirrors() const { return space.determinant() < 0; }
    Real hand() const { return mirrors() ? Real(-1) : Real(1); }

    Model operator()(const Model& model) const;
    /// An outcome of the changed model as one of the original, `model`.
    Outcome back(const Outcome& changed, const Model& model) const;

  private:
    Mat3 axes_of_body(int i) const;
    int place(int i) const;
    Vec3 point(int body, const Vec3& r) const;
    Mat3 frame(int body, const Mat3& A, const Mat3& signs) const;
    Body body(const Body& old, int i) const;
    Joint joint(const Joint& old, bool reverse) const;
    Load load(const Load& old) const;
    Spring spring(const Spring& old) const;
    TorsionSpring torsion_spring(const TorsionSpring& old) const;
    PolynomialSpring polynomial_spring(const PolynomialSpring& old) const;
    Damper damper(const Damper& old) const;
    RotationalDamper rotational_damper(const RotationalDamper& old) const;
    Attraction attraction(const Attraction& old) const;
    Bushing bushing(const Bushing& old) const;
    Action back(const Action& action) const;
    std::map<std::string, Real> integrals_back(const Outcome& changed, const Model& model) const;
    void add_components(const std::string& name, const std::map<std::string, Real>& from, const Vec3& offset,
                        const Real& factor, std::map<std::string, Real>& to) const;
};

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
