// SPDX-License-Identifier: BSD-3-Clause
//
// Simbody [sherman2011] as an independent reference. Its equations differ from those under test: joint coordinates and
// recursion over a tree instead of six velocities per body and multipliers, loops closed by constraints.
// Simbody's headers are C++17 and ambiguous in C++20, so this header, which both sides include, uses none of our types.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace outside {

using Vec = Eigen::Vector3d;
using Mat = Eigen::Matrix3d;

inline constexpr int the_ground = -1;

/// Inertia about the mass centre in body axes.
struct RigidBody {
    double mass;
    Mat J;
};

/// A coordinate as a function of time: c_0 + c_1 t + ... and waves A sin(W t + p).
struct Law {
    struct Wave {
        double amplitude, frequency, phase;
    };
    std::vector<double> polynomial;
    std::vector<Wave> waves;
};

/// Points from the mass centre and axes (columns) in body axes, as in mechanics/model/model.hpp; the third axis is that
/// of the joint, whose type is named as there. A prescribed coordinate has a law, any other none; the lead is that of a
/// screw or a rack, the teeth are those of a gear.
struct Link {
    int first, second;
    std::string type;
    Vec r_first, r_second;
    Mat axes_first, axes_second;
    double length;
    double lead = 0;
    std::optional<Law> turn = {}, shift = {};
    int teeth[2] = {0, 0};
};

struct LinearSpring {
    int first, second;
    Vec r_first, r_second;
    double stiffness, damping, length;
};

/// Stiffness and damping along the axes of the first frame, and about the axes of the angles.
struct SixSprings {
    int first, second;
    Vec r_first, r_second;
    Mat axes_first, axes_second;
    Vec stiffness, torsional_stiffness, damping, torsional_damping;
};

/// Constant force and torque in space axes, the force at a point in body axes.
struct DeadLoad {
    int body;
    Vec force, torque, point;
};

struct Mechanism {
    std::vector<RigidBody> bodies;
    std::vector<Link> links;
    std::vector<LinearSpring> springs;
    std::vector<SixSprings> bushings;
    std::vector<DeadLoad> loads;
    Vec gravity;
};

/// x, v in space axes, omega in body axes.
struct Pose {
    Vec x;
    Mat R;
    Vec v, omega;
};

/// x'' in space axes, omega' in body axes.
struct Acceleration {
    Vec linear, angular;
};

/// What a joint of the tree does to the body it holds: force in space axes, torque about the mass centre in body axes.
struct Reaction {
    int joint, body;
    Vec force, torque;
};

/// A mechanism in Simbody. Joints that reach a body for the first time are its mobilizers, whose coordinates may be
/// prescribed, all others and every distance joint are constraints; a body that no joint reaches is free. Throws
/// std::invalid_argument for joints Simbody lacks. Wheels that mesh, and racks, couple the coordinates of joints of the
/// tree, which are to hold both bodies to the ground, named first, about or along the axes of the mesh.
class Simbody {
  public:
    explicit Simbody(const Mechanism& mechanism);
    ~Simbody();
    Simbody(Simbody&&) noexcept;

    /// Joint coordinates and speeds that fit the bodies; parts that the joints of the tree do not allow are lost.
    void set(const std::vector<Pose>& bodies);
    std::vector<Pose> poses() const;
    std::vector<Acceleration> accelerations() const;
    std::vector<Reaction> reactions() const;
    /// By the integrator of Runge, Kutta and Merson from t = 0, at relative accuracy `accuracy`.
    void run(double t_end, double accuracy);

    /// For benchmarks. One forward dynamics with no cached state; one step of the classical Runge-Kutta method
    /// on coordinates and speeds, quaternions made unit afterwards.
    void evaluate();
    void step(double h);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace outside
