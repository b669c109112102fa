// SPDX-License-Identifier: BSD-3-Clause
#include "engine/linearised/symmetries.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <type_traits>

#include "mechanics/model/driven.hpp"
#include "mechanics/model/scales.hpp"
#include "mechanics/model/symmetries.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Data written as decimals satisfy such conditions to round-off if they are meant to.
const Real round_off_pivot = 1024 * epsilon;

/// Linear conditions on (w, u/length), the velocity field u + w x (P - origin): one row for each.
class Conditions {
  public:
    Conditions(const Vec3& origin, const Real& length) : origin_(origin), length_(length) {}

    void direction_stays(const Vec3& e) {
        if (!e.isZero(0)) add(hat(e.normalized()), Mat3::Zero());
    }
    void nothing_turns() { add(Mat3::Identity(), Mat3::Zero()); }
    void point_stays(const Vec3& P) { point_moves_freely(P, Mat3::Identity()); }
    void moves_along_only(const Vec3& P, const Vec3& e) { point_moves_freely(P, hat(e.normalized())); }
    void moves_across_only(const Vec3& P, const Vec3& e) {
        Mat3 along = Mat3::Zero();
        along.row(0) = e.normalized().transpose();
        point_moves_freely(P, along);
    }

    /// Orthonormal columns (w, u/length) that meet all conditions.
    MatX solutions() const {
        if (rows_.empty()) return MatX::Identity(6, 6);
        MatX transposed(6, static_cast<Eigen::Index>(rows_.size()));
        for (std::size_t i = 0; i < rows_.size(); ++i) transposed.col(static_cast<Eigen::Index>(i)) = rows_[i];
        Eigen::ColPivHouseholderQR<MatX> qr;
        qr.setThreshold(round_off_pivot);
        qr.compute(transposed);
        const MatX Q = qr.householderQ() * MatX::Identity(6, 6);
        return Q.rightCols(6 - qr.rank());
    }

  private:
    /// The part `fixed` of the velocity of P is zero.
    void point_moves_freely(const Vec3& P, const Mat3& fixed) {
        add(-fixed * hat(Vec3((P - origin_) / length_)), fixed);
    }
    void add(const Mat3& of_w, const Mat3& of_u) {
        for (int i = 0; i < 3; ++i) {
            VecX row(6);
            row << of_w.row(i).transpose(), of_u.row(i).transpose();
            rows_.push_back(row);
        }
    }

    Vec3 origin_;
    Real length_;
    std::vector<VecX> rows_;
};

/// What the ground side of a joint asks for, by the motions that the joint leaves free.
void add_joint(const Joint& joint, Conditions& conditions) {
    if (joint.first != ground && joint.second != ground) return;
    const bool first = joint.first == ground;
    const Vec3 point = first ? joint.r_first : joint.r_second;
    const Vec3 axis = (first ? joint.axes_first : joint.axes_second).col(2);
    const auto has = [&](FreeMotion motion) { return joint.type->has(motion); };
    const bool rolls = has(FreeMotion::roll);
    if (!has(FreeMotion::turn_about_point)) {
        const bool turns = rolls || has(FreeMotion::turn_about_axis) || has(FreeMotion::turn_about_two) ||
                           has(FreeMotion::turn_about_normal);
        turns ? conditions.direction_stays(axis) : conditions.nothing_turns();
    }
    if (rolls || has(FreeMotion::slide_across_axis))
        conditions.moves_across_only(point, axis);
    else if (has(FreeMotion::slide_along_axis))
        conditions.moves_along_only(point, axis);
    else
        conditions.point_stays(point);
}

template <class Force>
void add_force(const Force& force, Conditions& conditions) {
    if constexpr (std::is_same_v<Force, Load>) {
        if (force.axes == Load::Axes::body) return;
        conditions.direction_stays(force.force);
        conditions.direction_stays(force.torque);
    } else {
        if (force.is_internal()) return;
        const Vec3* centre = force.touches(ground) ? force.centre_on(ground) : nullptr;
        if (!centre) conditions.nothing_turns();
        if (centre) conditions.point_stays(*centre);
        if (!centre && force.may_push(ground)) conditions.point_stays(Vec3::Zero());
    }
}

/// Whether a disk may spin about its own axis: it is symmetric about it.
bool is_central_disk(const Model& model, const Joint& joint, int body) {
    if (!joint.type->has(FreeMotion::roll) || joint.second != body) return false;
    const Vec3 axis = joint.axes_second.col(2);
    const Mat3& J = model.bodies[static_cast<std::size_t>(body)].J;
    const Vec3 turned = J * axis;
    return joint.r_second.cross(axis).norm() <= round_off_pivot * joint.length &&
           turned.cross(axis).norm() <= round_off_pivot * turned.norm();
}

}  // namespace

std::vector<Generator> space_symmetries(const Model& model) {
    const Real size = extent(model), length = size > 0 ? size : Real(1);
    const Vec3 origin = model.bodies.empty() ? Vec3(Vec3::Zero()) : model.bodies[0].start.x;
    Conditions conditions(origin, length);
    conditions.direction_stays(model.gravity.g);
    for (const Joint& joint : model.joints) add_joint(joint, conditions);
    model.each([&](const auto& force, std::size_t) { add_force(force, conditions); });
    const MatX basis = conditions.solutions();
    std::vector<Generator> all;
    for (Eigen::Index i = 0; i < basis.cols(); ++i) {
        Generator one;
        one.w = basis.col(i).head<3>();
        one.u = length * basis.col(i).tail<3>() - one.w.cross(origin);
        one.spins.assign(model.bodies.size(), Vec3::Zero());
        all.push_back(one);
    }
    return all;
}

std::vector<Generator> spin_symmetries(const Model& model) {
    std::vector<Generator> all;
    std::vector<BodyTies> ties = ties_of_bodies(model);
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const int body = static_cast<int>(i);
        // Disks aside, what leaves a spin free is what leaves its momentum constant.
        std::erase_if(ties[i].joints, [&](const Joint* joint) { return is_central_disk(model, *joint, body); });
        const auto axis = free_spin_axis(model.bodies[i], body, ties[i]);
        if (!axis) continue;
        Generator one;
        one.spins.assign(model.bodies.size(), Vec3::Zero());
        one.spins[i] = *axis;
        all.push_back(one);
    }
    return all;
}

Generator combination(const std::vector<Generator>& all, const VecX& factors) {
    Generator sum;
    if (!all.empty()) sum.spins.assign(all[0].spins.size(), Vec3::Zero());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Real factor = factors[static_cast<Eigen::Index>(i)];
        sum.w += factor * all[i].w;
        sum.u += factor * all[i].u;
        for (std::size_t k = 0; k < sum.spins.size(); ++k) sum.spins[k] += factor * all[i].spins[k];
    }
    return sum;
}

std::string why_not_autonomous(const Model& model) {
    if (!model.gravity.is_constant()) return "gravity is modulated";
    for (std::size_t i = 0; i < model.joints.size(); ++i)
        if (is_driven(model.joints[i])) return model.name_of_joint(i) + " is driven";
    for (const Load& load : model.loads)
        if (load.amplitude != 0) return "a load on body \"" + model.name_of(load.body) + "\" is modulated";
    return "";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
