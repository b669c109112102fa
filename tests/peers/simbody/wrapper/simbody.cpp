// SPDX-License-Identifier: BSD-3-Clause
#include "tests/peers/simbody/wrapper/simbody.hpp"

// Simbody's classes have another layout with NDEBUG, and Debian compiles it without. Eigen must keep it.
#undef NDEBUG
#include <Simbody.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace outside {

namespace {

SimTK::Vec3 vec(const Vec& v) { return {v[0], v[1], v[2]}; }
Vec vec(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }
SimTK::UnitVec3 direction(const Vec& v) { return SimTK::UnitVec3(vec(v)); }
SimTK::Rotation rotation(const Mat& R) {
    return SimTK::Rotation(
        SimTK::Mat33(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
        true);  // used as given: fitting it again would lose digits
}
Mat matrix(const SimTK::Rotation& R) {
    Mat result;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result(i, j) = R[i][j];
    return result;
}
SimTK::Transform frame(const Mat& axes, const Vec& point) { return {rotation(axes), vec(point)}; }

/// Columns k, k + 1, k + 2 of the axes, cyclic.
Mat from_column(const Mat& axes, int k) {
    Mat result;
    result << axes.col(k), axes.col((k + 1) % 3), axes.col((k + 2) % 3);
    return result;
}

SimTK::Body rigid(const RigidBody& body) {
    const Mat& J = body.J;
    const SimTK::Inertia inertia(J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2));
    return SimTK::Body::Rigid(SimTK::MassProperties(body.mass, SimTK::Vec3(0), inertia));
}

/// A law, times a sign.
class LawFunction : public SimTK::Function {
  public:
    LawFunction(Law law, int sign) : law_(std::move(law)), sign_(sign) {}
    SimTK::Real calcValue(const SimTK::Vector& t) const override { return derivative(t[0], 0); }
    SimTK::Real calcDerivative(const SimTK::Array_<int>& components, const SimTK::Vector& t) const override {
        return derivative(t[0], static_cast<int>(components.size()));
    }
    int getArgumentSize() const override { return 1; }
    int getMaxDerivativeOrder() const override { return 2; }
    LawFunction* clone() const override { return new LawFunction(*this); }

  private:
    double derivative(double t, int order) const {
        double sum = 0;
        for (int j = order; j < static_cast<int>(law_.polynomial.size()); ++j) {
            double term = law_.polynomial[static_cast<std::size_t>(j)] * std::pow(t, j - order);
            for (int i = 0; i < order; ++i) term *= j - i;
            sum += term;
        }
        for (const Law::Wave& wave : law_.waves)
            sum += wave.amplitude * std::pow(wave.frequency, order) *
                   std::sin(wave.frequency * t + wave.phase + order * SimTK::Pi / 2);
        return sign_ * sum;
    }

    Law law_;
    int sign_;
};

/// One end of a joint.
struct End {
    Vec point;
    Mat axes;
};

/// Mobilizers whose axis is the third of both frames, the first (slider), or the first of the parent and the second of
/// the child (universal).
SimTK::MobilizedBody mobilizer(const Link& joint, SimTK::MobilizedBody& parent, const End& at_parent,
                               const SimTK::Body& body, const End& at_child) {
    using M = SimTK::MobilizedBody;
    const std::string& type = joint.type;
    const auto F = [&](int k) { return frame(from_column(at_parent.axes, k), at_parent.point); };
    const auto B = [&](int k) { return frame(from_column(at_child.axes, k), at_child.point); };
    if (type == "spherical") return M::Ball(parent, F(0), body, B(0));
    if (type == "revolute") return M::Pin(parent, F(0), body, B(0));
    if (type == "universal") return M::Universal(parent, F(2), body, B(1));
    if (type == "prismatic") return M::Slider(parent, F(2), body, B(2));
    if (type == "cylindrical") return M::Cylinder(parent, F(0), body, B(0));
    if (type == "screw") return M::Screw(parent, F(0), body, B(0), joint.lead / (2 * SimTK::Pi));
    if (type == "planar") return M::Planar(parent, F(0), body, B(0));
    if (type == "fixed") return M::Weld(parent, F(0), body, B(0));
    throw std::invalid_argument("Simbody has no mobilizer: " + type);
}

/// The constraints of Simbody that are equivalent to a joint.
void constrain(const Link& joint, SimTK::MobilizedBody& first, SimTK::MobilizedBody& second) {
    using C = SimTK::Constraint;
    const Mat &a = joint.axes_first, &b = joint.axes_second;
    const auto point = [&] { C::Ball(first, vec(joint.r_first), second, vec(joint.r_second)); };
    const auto plane = [&](int k) {
        const Vec normal = b.col(k);
        C::PointInPlane(second, direction(normal), normal.dot(joint.r_second), first, vec(joint.r_first));
    };
    const auto right_angle = [&](int j, int k) {
        C::ConstantAngle(first, direction(a.col(j)), second, direction(b.col(k)));
    };
    const auto parallel = [&] { right_angle(2, 0), right_angle(2, 1); };
    if (joint.type == "spherical") return point();
    if (joint.type == "revolute") return point(), parallel();
    if (joint.type == "universal") return point(), right_angle(2, 2);
    if (joint.type == "prismatic") return plane(0), plane(1), parallel(), right_angle(0, 1);
    if (joint.type == "cylindrical") return plane(0), plane(1), parallel();
    if (joint.type == "planar") return plane(2), parallel();
    if (joint.type == "fixed")
        C::Weld(first, frame(a, joint.r_first), second, frame(b, joint.r_second));
    else if (joint.type == "distance")
        C::Rod(first, vec(joint.r_first), second, vec(joint.r_second), joint.length);
    else
        throw std::invalid_argument("Simbody has no constraint: " + joint.type);
}

}  // namespace

struct Simbody::Parts {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    std::vector<SimTK::MobilizedBody> bodies;
    std::vector<int> order;     ///< of the bodies, parents first
    std::vector<int> joint_of;  ///< the joint of the tree that holds a body, or -1
    SimTK::State state;

    explicit Parts(const Mechanism& mechanism)
        : bodies(mechanism.bodies.size()), joint_of(mechanism.bodies.size(), -1) {
        grow_tree(mechanism);
        for (std::size_t j = 0; j < mechanism.links.size(); ++j)
            if (!is_in_tree(static_cast<int>(j))) {
                const Link& joint = mechanism.links[j];
                if (meshes(joint))
                    couple(joint);
                else
                    constrain(joint, body(joint.first), body(joint.second));
            }
        add_forces(mechanism);
        state = system.realizeTopology();
    }

    SimTK::MobilizedBody& body(int index) {
        return index == the_ground ? matter.updGround() : bodies[static_cast<std::size_t>(index)];
    }
    bool is_reached(int index) { return index == the_ground || !body(index).isEmptyHandle(); }
    bool is_in_tree(int joint) const { return std::find(joint_of.begin(), joint_of.end(), joint) != joint_of.end(); }

    void grow_tree(const Mechanism& mechanism) {
        while (order.size() < bodies.size())
            if (!reach_by_joint(mechanism)) reach_freely(mechanism);
    }
    bool reach_by_joint(const Mechanism& mechanism) {
        for (std::size_t j = 0; j < mechanism.links.size(); ++j) {
            const Link& joint = mechanism.links[j];
            if (joint.type == "distance" || meshes(joint) || is_reached(joint.first) == is_reached(joint.second))
                continue;
            const bool forwards = is_reached(joint.first);
            const End first{joint.r_first, joint.axes_first}, second{joint.r_second, joint.axes_second};
            const int parent = forwards ? joint.first : joint.second, child = forwards ? joint.second : joint.first;
            const SimTK::Body mass = rigid(mechanism.bodies[static_cast<std::size_t>(child)]);
            body(child) = mobilizer(joint, body(parent), forwards ? first : second, mass, forwards ? second : first);
            prescribe(joint, body(child), forwards ? 1 : -1);
            joint_of[static_cast<std::size_t>(child)] = static_cast<int>(j);
            order.push_back(child);
            return true;
        }
        return false;
    }
    static bool meshes(const Link& joint) { return joint.type == "gear" || joint.type == "rack"; }
    /// z_1 q_1 + z_2 q_2 = 0 of wheels, 2 pi/lead q_1 - q_2 = 0 of a rack and its pinion.
    void couple(const Link& joint) {
        SimTK::Vector factors(3, 0.0);
        if (joint.type == "gear")
            factors[0] = joint.teeth[0], factors[1] = joint.teeth[1];
        else
            factors[0] = 2 * SimTK::Pi / joint.lead, factors[1] = -1;
        SimTK::Array_<SimTK::MobilizedBodyIndex> coupled;
        for (const int index : {joint.first, joint.second}) coupled.push_back(body(index).getMobilizedBodyIndex());
        SimTK::Constraint::CoordinateCoupler(matter, new SimTK::Function::Linear(factors), coupled,
                                             SimTK::Array_<SimTK::MobilizerQIndex>(2, SimTK::MobilizerQIndex(0)));
    }
    /// A cylinder turns by its first coordinate and slides by its second.
    void prescribe(const Link& joint, SimTK::MobilizedBody& child, int sign) {
        const auto hold = [&](const Law& law, int coordinate) {
            SimTK::Constraint::PrescribedMotion(matter, new LawFunction(law, sign), child.getMobilizedBodyIndex(),
                                                SimTK::MobilizerQIndex(coordinate));
        };
        if (joint.turn) hold(*joint.turn, 0);
        if (joint.shift) hold(*joint.shift, joint.type == "cylindrical" ? 1 : 0);
    }
    void reach_freely(const Mechanism& mechanism) {
        int index = 0;
        while (is_reached(index)) ++index;
        body(index) =
            SimTK::MobilizedBody::Free(matter.updGround(), rigid(mechanism.bodies[static_cast<std::size_t>(index)]));
        order.push_back(index);
    }
    void add_forces(const Mechanism& mechanism) {
        using F = SimTK::Force;
        F::UniformGravity(forces, matter, vec(mechanism.gravity));
        for (const LinearSpring& s : mechanism.springs) {
            auto &first = body(s.first), &second = body(s.second);
            F::TwoPointLinearSpring(forces, first, vec(s.r_first), second, vec(s.r_second), s.stiffness, s.length);
            F::TwoPointLinearDamper(forces, first, vec(s.r_first), second, vec(s.r_second), s.damping);
        }
        const auto six = [](const Vec& about, const Vec& along) {
            return SimTK::Vec6(about[0], about[1], about[2], along[0], along[1], along[2]);
        };
        for (const SixSprings& b : mechanism.bushings)
            F::LinearBushing(forces, body(b.first), frame(b.axes_first, b.r_first), body(b.second),
                             frame(b.axes_second, b.r_second), six(b.torsional_stiffness, b.stiffness),
                             six(b.torsional_damping, b.damping));
        for (const DeadLoad& load : mechanism.loads) {
            F::ConstantForce(forces, body(load.body), vec(load.point), vec(load.force));
            F::ConstantTorque(forces, body(load.body), vec(load.torque));
        }
    }

    /// Pose and velocity of the frame M of a mobilizer in its frame F, from those of the body in space.
    void fit(int index, const Pose& target) {
        const SimTK::MobilizedBody& child = body(index);
        const SimTK::MobilizedBody& parent = child.getParentMobilizedBody();
        const SimTK::Transform X_GB = frame(target.R, target.x), X_GM = X_GB * child.getOutboardFrame(state);
        const SimTK::Transform X_GF = parent.getBodyTransform(state) * child.getInboardFrame(state);
        child.setQToFitTransform(state, ~X_GF * X_GM);
        system.realize(state, SimTK::Stage::Velocity);  // new coordinates: the parent's velocity is read again
        const SimTK::Vec3 omega = X_GB.R() * vec(target.omega), arm = X_GM.p() - X_GB.p();
        const SimTK::SpatialVec V_GP = parent.getBodyVelocity(state);
        const SimTK::Vec3 v_P = V_GP[1] + SimTK::cross(V_GP[0], X_GM.p() - parent.getBodyOriginLocation(state));
        const SimTK::Vec3 v_M = vec(target.v) + SimTK::cross(omega, arm);
        child.setUToFitVelocity(state, {~X_GF.R() * (omega - V_GP[0]), ~X_GF.R() * (v_M - v_P)});
        system.realize(state, SimTK::Stage::Velocity);
    }
};

Simbody::Simbody(const Mechanism& mechanism) : parts_(std::make_unique<Parts>(mechanism)) {}
Simbody::~Simbody() = default;
Simbody::Simbody(Simbody&&) noexcept = default;

void Simbody::set(const std::vector<Pose>& bodies) {
    parts_->system.realize(parts_->state, SimTK::Stage::Velocity);
    for (const int index : parts_->order) parts_->fit(index, bodies[static_cast<std::size_t>(index)]);
}

std::vector<Pose> Simbody::poses() const {
    parts_->system.realize(parts_->state, SimTK::Stage::Velocity);
    std::vector<Pose> poses;
    for (const SimTK::MobilizedBody& body : parts_->bodies) {
        const SimTK::Transform& X = body.getBodyTransform(parts_->state);
        const SimTK::SpatialVec& V = body.getBodyVelocity(parts_->state);
        poses.push_back({vec(X.p()), matrix(X.R()), vec(V[1]), vec(~X.R() * V[0])});
    }
    return poses;
}

std::vector<Acceleration> Simbody::accelerations() const {
    parts_->system.realize(parts_->state, SimTK::Stage::Acceleration);
    std::vector<Acceleration> result;
    for (const SimTK::MobilizedBody& body : parts_->bodies) {
        const SimTK::SpatialVec& A = body.getBodyAcceleration(parts_->state);
        result.push_back({vec(A[1]), vec(~body.getBodyRotation(parts_->state) * A[0])});
    }
    return result;
}

std::vector<Reaction> Simbody::reactions() const {
    parts_->system.realize(parts_->state, SimTK::Stage::Acceleration);
    std::vector<Reaction> result;
    for (std::size_t i = 0; i < parts_->bodies.size(); ++i) {
        if (parts_->joint_of[i] < 0) continue;
        const SimTK::MobilizedBody& body = parts_->bodies[i];
        const SimTK::SpatialVec W = body.findMobilizerReactionOnBodyAtOriginInGround(parts_->state);
        const SimTK::Vec3 torque = ~body.getBodyRotation(parts_->state) * W[0];
        result.push_back({parts_->joint_of[i], static_cast<int>(i), vec(W[1]), vec(torque)});
    }
    return result;
}

void Simbody::run(double t_end, double accuracy) {
    SimTK::RungeKuttaMersonIntegrator integrator(parts_->system);
    integrator.setAccuracy(accuracy);
    integrator.setConstraintTolerance(accuracy / 10);
    integrator.setFinalTime(t_end);
    parts_->state.setTime(0);
    SimTK::TimeStepper stepper(parts_->system, integrator);
    stepper.initialize(parts_->state);
    stepper.stepTo(t_end);
    parts_->state = stepper.getState();
}

void Simbody::evaluate() {
    parts_->state.updQ(), parts_->state.updU();  // write access invalidates what depends on them
    parts_->system.realize(parts_->state, SimTK::Stage::Acceleration);
}

void Simbody::step(double h) {
    SimTK::State& state = parts_->state;
    const SimTK::Vector start = state.getY();
    SimTK::Vector sum(start.size(), 0.0);
    const double weights[] = {h / 6, h / 3, h / 3, h / 6}, next[] = {h / 2, h / 2, h, 0};
    for (int i = 0; i < 4; ++i) {
        parts_->system.realize(state, SimTK::Stage::Acceleration);
        const SimTK::Vector& slope = state.getYDot();
        sum += weights[i] * slope;
        state.updY() = start + (i < 3 ? next[i] * slope : sum);
    }
    parts_->matter.normalizeQuaternions(state);
}

}  // namespace outside
