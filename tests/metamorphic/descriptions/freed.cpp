// SPDX-License-Identifier: BSD-3-Clause
//
// A joint replaced by its wrench as a load: the accelerations at the start are unchanged.
// The wrench is computed from the multipliers as NOTATION.md defines them, without any row of C, so a row whose sign
// does not agree with that is seen.
#include "tests/metamorphic/descriptions/freed.hpp"

#include "mechanics/formulation.hpp"
#include "mechanics/joints/joint_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

/// Force on the second body and torque about its point of the joint, space axes: a multiplier of a row of d or of b.d
/// is a force on the second body along the row's direction, that of a row a.b the torque lambda a x b on it.
class Wrenches {
  public:
    Wrenches(const Joint& joint, const Motion& first, const Motion& second, const Real* lambda)
        : joint_(joint), first_(first), second_(second), lambda_(lambda) {
        d_ = first.point(joint.r_first) - second.point(joint.r_second);
    }

    Action on_second() {
        for (const JointRow& row : joint_.type->rows) add(row);
        return sum_;
    }

  private:
    void add(const JointRow& row) {
        switch (row.primitive) {
            case Primitive::coincidence:
                return coincidence();
            case Primitive::along:
                return push(row.k);
            case Primitive::orthogonal:
                return turn(row.i, row.k);
            case Primitive::distance:
                return force(d_.normalized() * next(), Vec3::Zero());
            case Primitive::contact:
                return contact();
            case Primitive::shift:
                return push(2);
            case Primitive::turn:
                return sum_.add({Vec3::Zero(), b(2) * next()});
            case Primitive::helix:
                return thread();
            case Primitive::rack:
                return rack();
            case Primitive::mesh:
                return mesh();
        }
    }
    const Real& next() { return *lambda_++; }
    Vec3 a(int k) const { return first_.direction(joint_.axes_first.col(k)); }
    Vec3 b(int k) const { return second_.direction(joint_.axes_second.col(k)); }
    /// At `arm` from the second body's point.
    void force(const Vec3& f, const Vec3& arm) { sum_.add({f, arm.cross(f)}); }
    void coincidence() {
        for (int k = 0; k < 3; ++k) force(Vec3::Unit(k) * next(), Vec3::Zero());
    }
    void push(int k) { force(b(k) * next(), d_); }
    void turn(int i, int k) { sum_.add({Vec3::Zero(), a(i).cross(b(k)) * next()}); }
    /// At the start, where the row is met.
    void thread() {
        const Real lambda = next();
        force(b(2) * (-2 * pi() / joint_.lead * lambda), d_);
        sum_.add({Vec3::Zero(), b(2) * lambda});
    }
    /// What the angle of a vector grows with about an axis.
    static Vec3 growth(const Vec3& vector, const Vec3& axis) {
        const Vec3 shadow = vector - vector.dot(axis) * axis;
        return axis.cross(shadow) / shadow.squaredNorm();
    }
    void rack() {
        const Real lambda = next(), radians = 2 * pi() / joint_.lead, f = radians * a(2).dot(d_);
        const Vec3 turned = cos(f) * a(2) - sin(f) * a(1), grows = growth(turned, b(2));
        force(a(2) * (radians * a(0).cross(turned).dot(grows) * lambda), Vec3::Zero());
        sum_.add({Vec3::Zero(), turned.cross(grows) * lambda});
    }
    void mesh() {
        const Real lambda = next();
        force(growth(d_, a(2)) * (lambda * joint_.teeth[0] / joint_.teeth[1]), Vec3::Zero());
        force(growth(d_, b(2)) * lambda, d_);
    }
    void contact() {
        const Vec3 n = a(2), s = n - n.dot(b(2)) * b(2), arm = -joint_.length / s.norm() * s;
        for (const int k : {2, 0, 1}) force(a(k) * next(), arm);
    }

    const Joint& joint_;
    const Motion &first_, &second_;
    const Real* lambda_;
    Vec3 d_;
    Action sum_;
};

std::vector<BodyState> starts(const Model& model) {
    std::vector<BodyState> states;
    for (const Body& body : model.bodies) states.push_back(body.start);
    return states;
}

/// The wrench of forces with torque about `point` (space), times a sign, as a load on a body.
void put(Model& model, int body, const Vec3& point, const Action& wrench, const Real& sign) {
    if (body == ground) return;
    const BodyState& s = model.bodies[static_cast<std::size_t>(body)].start;
    model.loads.push_back({.body = body,
                           .axes = Load::Axes::space,
                           .force = sign * wrench.force,
                           .torque = sign * wrench.torque,
                           .point = s.R.transpose() * (point - s.x)});
}

Model freed(const Model& model, std::size_t joint, const Action& wrench) {
    const Joint& gone = model.joints[joint];
    const Vec3 point = motion_of(starts(model), gone.second).point(gone.r_second);
    Model rest = model;
    rest.joints.erase(rest.joints.begin() + static_cast<std::ptrdiff_t>(joint));
    put(rest, gone.second, point, wrench, 1);
    put(rest, gone.first, point, wrench, -1);
    return rest;
}

VecX accelerations(const Model& model, System& system, Real* lambda) {
    const std::vector<Real> y = initial_state(system, model);
    VecX dv(system.velocities());
    const Status status = system.accelerations(0, y.data(), system.v(y.data()), dv.data(), lambda);
    if (status != Status::ok) dv.setConstant(std::numeric_limits<Real>::quiet_NaN());
    return dv;
}

}  // namespace

Real freed_difference(const Model& model, const Bench& bench) {
    const auto system = bench.system(model, "SO3xR3");
    std::vector<Real> lambda(static_cast<std::size_t>(system->constraints()));
    const VecX joined = accelerations(model, *system, lambda.data());
    const std::vector<BodyState> states = starts(model);
    Model loose = model;  // if joints hold all bodies at rest, accelerations are round-off of those without joints
    loose.joints.clear();
    const Real size =
        max(Real(joined.norm()), Real(accelerations(loose, *make_system(loose, "SO3xR3"), nullptr).norm()));
    std::size_t position = 0, velocity = static_cast<std::size_t>(system->position_constraints());
    Real worst = 0;
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
        const Joint& joint = model.joints[j];
        Real own[most_rows];
        for (int k = 0; k < rows_of(joint.type); ++k)
            own[k] = lambda[k < position_rows_of(joint.type) ? position++ : velocity++];
        const Motion first = motion_of(states, joint.first), second = motion_of(states, joint.second);
        const Model rest = freed(model, j, Wrenches(joint, first, second, own).on_second());
        const auto free_system = make_system(rest, "SO3xR3");
        const Real difference = (accelerations(rest, *free_system, nullptr) - joined).norm() / size;
        if (!(difference <= worst)) worst = difference;
    }
    return worst;
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
