// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/forces/bushing.hpp"

#include "mechanics/forces/entry.hpp"
#include "mechanics/forces/forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// p and q of a bushing. In space axes, the columns of `along` are the axes of the first frame, and those of `about`
/// the gradients of q: with the angular velocity w of the second body relative to the first, q_i' = about_i . w.
struct Displacement {
    Mat3 along, about;
    Vec3 p, q;
};

/// The axes about which q turn are the first of the first frame, f, their common normal, and the third of the second
/// frame, n, with f . n = sin q_2. The gradients are the basis dual to these three.
Displacement displacement(const Bushing& bushing, const Motion& one, const Motion& other) {
    const Mat3 A = one.R * bushing.axes_first, B = other.R * bushing.axes_second;
    const Mat3 Q = A.transpose() * B;
    const Vec3 f = A.col(0), n = B.col(2);
    const Real sine = f.dot(n), square = 1 - sine * sine;  // cos^2 q_2
    Displacement d;
    d.along = A;
    d.about << (f - sine * n) / square, n.cross(f) / sqrt(square), (n - sine * f) / square;
    d.p = A.transpose() * (other.point(bushing.r_second) - one.point(bushing.r_first));
    d.q = Vec3(atan2(-Q(1, 2), Q(2, 2)), atan2(Q(0, 2), sqrt(square)), atan2(-Q(0, 1), Q(0, 0)));
    return d;
}

}  // namespace

WrenchPair Bushing::exerted(const std::array<Vec3, 2>& stiffness_now, const Motion& one, const Motion& other) const {
    const Displacement d = displacement(*this, one, other);
    const Vec3 P = other.point(r_second);
    const Vec3 slip = other.point_velocity(r_second) - one.point_velocity(one.R.transpose() * (P - one.x));
    const Vec3 turning = other.R * other.omega - one.R * one.omega;
    const Vec3 p_rate = d.along.transpose() * slip, q_rate = d.about.transpose() * turning;
    const Vec3 force = -(d.along * (stiffness_now[0].cwiseProduct(d.p) + damping[0].cwiseProduct(p_rate)));
    const Vec3 torque = -(d.about * (stiffness_now[1].cwiseProduct(d.q) + damping[1].cwiseProduct(q_rate)));
    WrenchPair pair = {force_through(one, -force, P), force_at(other, force, r_second)};
    pair.first.torque -= one.R.transpose() * torque;
    pair.second.torque += other.R.transpose() * torque;
    return pair;
}

Real Bushing::stored(const Motion& one, const Motion& other) const {
    const Displacement d = displacement(*this, one, other);
    return (stiffness[0].dot(d.p.cwiseAbs2()) + stiffness[1].dot(d.q.cwiseAbs2())) / 2;
}

namespace {

void read_bushing(const ForceEntry& entry, Forces& forces) {
    forces.bushings.push_back({.first = entry.first,
                               .second = entry.second,
                               .r_first = entry.r_first,
                               .r_second = entry.r_second,
                               .axes_first = entry.axes_first,
                               .axes_second = entry.axes_second,
                               .stiffness = entry.stiffnesses,
                               .damping = entry.dampings});
}

}  // namespace

KREISEL_FORCE(Bushing::type, read_bushing);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
