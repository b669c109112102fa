// SPDX-License-Identifier: BSD-3-Clause
#include "problems/reading/joints.hpp"

#include <tuple>

#include "lie/so3.hpp"
#include "mechanics/parts/driven_joints.hpp"
#include "problems/reading/parts.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using reading::text;

/// Of one wheel: angles times teeth keep their digits.
constexpr long most_teeth = 1000;

Prescribed prescribed(const MotionData& data) {
    Prescribed law;
    for (const double c : data.polynomial) law.polynomial.push_back(decimal(c));
    for (const SinusoidData& one : data.sinusoids)
        law.sinusoids.push_back({decimal(one.amplitude), decimal(one.frequency), decimal(one.phase)});
    return law;
}

/// A frame about b whose first axis is that of `frame`, as far as b allows: where b is the axis of `frame` or its
/// opposite, the rows that compare first and second axes vanish.
Mat3 turned_onto(const Vec3& b, const Mat3& frame) {
    Mat3 axes = axes_about(b);
    const Vec3 e = axes.col(2);
    const Vec3 first = frame.col(0) - frame.col(0).dot(e) * e;
    if (first.norm() < Real(1) / 8) return axes;
    axes.col(0) = first.normalized();
    axes.col(1) = e.cross(axes.col(0));
    return axes;
}

/// `frame`, turned by the least rotation that takes its axis onto b; itself where b is the axis or its opposite.
Mat3 carried_onto(const Vec3& b, const Mat3& frame) {
    const Vec3 a = frame.col(2), line = a.cross(b);
    if (line.isZero(0)) return frame;
    return SO3::exp(atan2(line.norm(), a.dot(b)) * line.normalized()) * frame;
}

/// Reads one joint.
class JointReader {
  public:
    JointReader(const Model& model, const reading::NamedBodies& bodies, const JointData& data, std::size_t index,
                bool projected)
        : model_(model), bodies_(bodies), data_(data), projected_(projected), path_(reading::place("joints", index)) {
        who_ = "joint " + std::to_string(index) + " (" + data.between[0] + " - " + data.between[1] + ", " + data.type +
               ")";
        joint_.type = type();
    }

    Joint read() {
        const auto [first, second] = bodies_.between(data_.between, path_, who_);
        joint_.first = first, joint_.second = second;
        if (!data_.name.empty()) joint_.name = to_name(data_.name, path_ + "/name");
        check_point_masses();
        joint_.r_first = point(0, first), joint_.r_second = point(1, second);
        if (joint_.type->axes != JointAxes::none) read_axes();
        if (joint_.type->has(Primitive::distance)) read_distance();
        if (joint_.type->has(Primitive::contact)) read_contact();
        if (joint_.type->has(Primitive::helix)) read_lead();
        if (joint_.type->has(Primitive::mesh)) read_mesh();
        if (joint_.type->has(Primitive::rack)) read_rack();
        if (data_.turn || data_.shift) read_motions();
        return joint_;
    }

  private:
    JointType type() const {
        if (const JointKind* kind = find_joint_kind(data_.type)) return JointType(*kind);
        throw ParameterError(path_ + "/type", who_ + ": there is no joint of this type", data_.type, joint_names());
    }
    /// The place of one body's value: a value for both is written under the singular key.
    std::string at(const char* shared, const char* each, const std::array<Vector3, 2>& values, std::size_t body) const {
        return path_ + "/" + (values[0] == values[1] ? shared : each + ("/" + std::to_string(body)));
    }
    Vec3 point(std::size_t k, int body) const {
        return reading::point_on(model_, body, data_.points[k], at("point", "points", data_.points, k), who_);
    }
    Vec3 axis(std::size_t k) const { return reading::axis(data_.axes[k], at("axis", "axes", data_.axes, k), who_); }

    void check_point_masses() const {
        if (joint_.type->holds_points) return;
        for (std::size_t k = 0; k < 2; ++k) {
            const int body = k == 0 ? joint_.first : joint_.second;
            if (body == ground || !model_.bodies[static_cast<std::size_t>(body)].point) continue;
            throw ParameterError(path_ + "/between/" + std::to_string(k),
                                 who_ + ": expected a rigid body; \"" + data_.between[k] +
                                     "\" is a point mass, which has no axes: only " + joints_that_hold_points() +
                                     " joints hold it");
        }
    }

    void read_axes() {
        const Vec3 a = axis(0), b = axis(1);
        const Mat3 first = axes_about(a);
        const Real cosine = first.col(2).dot(axes_about(b).col(2));
        if (joint_.type->axes == JointAxes::perpendicular) check_perpendicular(cosine);
        if (joint_.type->axes == JointAxes::not_parallel && abs(cosine) > 1 - Real(1) / 1000000000)
            throw ParameterError(path_ + "/axes", who_ +
                                                      ": expected a disk that does not lie flat on the plane, got axes "
                                                      "that are parallel: the point of contact is not determined");
        joint_.axes_first = model_.axes_of(joint_.first, first);
        const bool common = joint_.type->axes == JointAxes::common;
        joint_.axes_second = model_.axes_of(joint_.second, turned_onto(b, common ? carried_onto(b, first) : first));
    }

    void check_perpendicular(const Real& cosine) const {
        const Real most = projected_ ? Real(1) / 2 : Real(1) / 1000000000;
        if (abs(cosine) <= most) return;
        const Real degrees = 180 / pi() * acos(min(Real(1), max(Real(-1), cosine)));
        throw ParameterError(path_ + "/axes", who_ + ": expected perpendicular axes, got an angle of " + text(degrees) +
                                                  " degrees between them");
    }

    void read_distance() {
        const Real initial = (to_vec3(data_.points[0]) - to_vec3(data_.points[1])).norm();
        if (initial == 0)
            throw ParameterError(path_ + "/points", who_ + ": expected two different points, got the same twice");
        joint_.length = data_.length ? positive_length("length") : initial;
        joint_.amplitude = decimal(data_.amplitude), joint_.frequency = decimal(data_.frequency);
        if (abs(joint_.amplitude) >= 1)
            throw ParameterError(path_ + "/amplitude",
                                 who_ +
                                     ": expected an amplitude between -1 and 1, or the length would "
                                     "reach 0; got " +
                                     text(joint_.amplitude));
    }

    void read_contact() {
        if (joint_.first != ground || joint_.second == ground)
            throw ParameterError(path_ + "/between",
                                 who_ + ": expected \"ground\", which carries the plane, and then the disk");
        joint_.length = positive_length("radius");
    }

    /// d in the configuration as given.
    Vec3 apart() const {
        const BodyState rest;
        const auto at = [&](int body) -> const BodyState& {
            return body == ground ? rest : model_.bodies[static_cast<std::size_t>(body)].start;
        };
        const BodyState &first = at(joint_.first), &second = at(joint_.second);
        return first.x + first.R * joint_.r_first - second.x - second.R * joint_.r_second;
    }
    /// b_3.d there.
    Real shift_back() const { return apart().dot(axis(1).normalized()); }

    /// Coordinates are measured from the configuration as given: there the first axes of the bodies are the same, up to
    /// the turn that makes the axes parallel, and what the points are apart is not a shift.
    void check_directed() const {
        const Vec3 a = axis(0), b = axis(1);
        if (projected_ || a.dot(b) > 0) return;
        const Real cosine = a.dot(b) / (a.norm() * b.norm());
        throw ParameterError(path_ + "/axes", who_ +
                                                  ": expected axes that point the same way, about which a turn is "
                                                  "counted from the first body to the second; got axes " +
                                                  text(180 / pi() * acos(max(Real(-1), cosine))) + " degrees apart");
    }

    void read_motions() {
        const Drive drive{data_.turn.has_value(), data_.shift.has_value()},
            most = drivable(*find_joint_kind(data_.type));
        for (const auto& [key, wanted, possible] :
             {std::tuple("turn", drive.turn, most.turn), std::tuple("shift", drive.shift, most.shift)})
            if (wanted && !possible)
                throw ParameterError(path_ + "/" + key, who_ + ": expected a joint that leaves a " + key +
                                                            " free, got one that has none to prescribe");
        check_directed();
        if (data_.turn) joint_.turn = prescribed(*data_.turn);
        if (data_.shift) {
            joint_.shift = prescribed(*data_.shift);
            if (joint_.shift.polynomial.empty()) joint_.shift.polynomial = {0};
            joint_.shift.polynomial[0] -= shift_back();
        }
        joint_.type = driven(joint_.type, drive);
    }

    void read_lead() {
        if (!data_.lead || *data_.lead == 0 || !isfinite(Real(*data_.lead)))
            throw ParameterError(path_ + "/lead",
                                 who_ + ": expected a lead in m, not 0 (below 0: a left-handed thread), got " +
                                     (data_.lead ? text(Real(*data_.lead)) : "nothing"));
        check_directed();
        joint_.lead = decimal(*data_.lead);
        const Real angle = 2 * pi() * shift_back() / joint_.lead;
        const Mat3 axes = joint_.axes_first;
        joint_.axes_first.col(0) = cos(angle) * axes.col(0) + sin(angle) * axes.col(1);
        joint_.axes_first.col(1) = cos(angle) * axes.col(1) - sin(angle) * axes.col(0);
    }

    /// The teeth that touch at the start are those on the line of centres: both first axes are along it.
    void read_mesh() {
        for (std::size_t k = 0; k < 2; ++k) {
            if (data_.teeth[k] == 0 || abs(Real(data_.teeth[k])) > most_teeth)
                throw ParameterError(path_ + "/teeth/" + std::to_string(k),
                                     who_ + ": expected a number of teeth from 1 to " + std::to_string(most_teeth) +
                                         ", or below 0 of a ring with its teeth inside, got " +
                                         std::to_string(data_.teeth[k]));
            joint_.teeth[k] = static_cast<int>(data_.teeth[k]);
        }
        const Vec3 a = axis(0).normalized(), b = axis(1).normalized(), d = apart();
        check_parallel(a, b);
        // Of wheels yet to be turned, the one that lies along the line of centres stands as it will.
        const Vec3 n = projected_ && abs(a.dot(d)) < abs(b.dot(d)) ? a : b, line = d - d.dot(n) * n;
        if (line.norm() <= d.norm() / 1000000000)
            throw ParameterError(path_ + "/points",
                                 who_ +
                                     ": expected the centres of two wheels that mesh, got two points "
                                     "on one axis");
        const Vec3 e = line.normalized();
        Mat3 axes;
        axes << e, n.cross(e), n;
        joint_.axes_first = model_.axes_of(joint_.first, carried_onto(a, axes)),
        joint_.axes_second = model_.axes_of(joint_.second, carried_onto(b, axes));
    }
    void check_parallel(const Vec3& a, const Vec3& b) const {
        const Real small = Real(1) / 1000000000;
        if ((a - b).norm() <= small || (projected_ && (a + b).norm() > small)) return;
        throw ParameterError(path_ + "/axes", who_ + ": expected wheels about one direction, got axes " +
                                                  text(180 / pi() * acos(max(Real(-1), min(Real(1), Real(a.dot(b)))))) +
                                                  " degrees apart");
    }

    /// With the rack's direction e and the pinion's axis n, the rack's point is r from the centre on the side n x e or
    /// the other; the pinion turns by what the rack moves over r, about n if it is on the former.
    void read_rack() {
        const Vec3 e = axis(0).normalized(), n = axis(1).normalized(), side = n.cross(e).normalized(), d = apart();
        const Real radius = d.dot(side);
        if (abs(radius) <= d.norm() / 1000000000)
            throw ParameterError(path_ + "/points",
                                 who_ +
                                     ": expected a point on the pitch line of the rack and the centre "
                                     "of the pinion, which is the radius away; got 0 m");
        joint_.lead = -2 * pi() * radius;
        const Real angle = 2 * pi() * e.dot(d) / joint_.lead, c = cos(angle), s = sin(angle);
        Mat3 rack, pinion;
        const Vec3 across = side.cross(n);  // e, unless the axes are yet to be made perpendicular
        rack << e.cross(side), -side, e;
        pinion << c * across + s * side, c * side - s * across, n;
        joint_.axes_first = model_.axes_of(joint_.first, rack);
        joint_.axes_second = model_.axes_of(joint_.second, pinion);
    }

    Real positive_length(const char* key) const {
        if (!data_.length || !(*data_.length > 0))
            throw ParameterError(path_ + "/" + key, who_ + ": expected a " + key + " greater than 0, got " +
                                                        (data_.length ? text(Real(*data_.length)) : "nothing"));
        return decimal(*data_.length);
    }

    const Model& model_;
    const reading::NamedBodies& bodies_;
    const JointData& data_;
    bool projected_;
    std::string path_, who_;
    Joint joint_;
};

}  // namespace

void read_joints(Model& model, const std::vector<JointData>& joints, bool projected) {
    const reading::NamedBodies bodies(model);
    for (std::size_t i = 0; i < joints.size(); ++i)
        model.joints.push_back(JointReader(model, bodies, joints[i], i, projected).read());
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
