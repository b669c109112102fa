// SPDX-License-Identifier: BSD-3-Clause
//
// A model written down as data and read again. Absent parts are not written, as users do.
#include "tests/metamorphic/descriptions/written.hpp"

#include "problems/problem.hpp"
#include "tests/metamorphic/models/motion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

Vector3 data(const Vec3& v) { return {to_double(v[0]), to_double(v[1]), to_double(v[2])}; }

Matrix3 data(const Mat3& A) {
    Matrix3 rows;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) rows[static_cast<std::size_t>(3 * i + k)] = to_double(A(i, k));
    return rows;
}

/// Coordinates are written from the configuration at the start.
MotionData from_the_start(const Prescribed& law) {
    MotionData written;
    for (const Real& c : law.polynomial) written.polynomial.push_back(to_double(c));
    for (const Sinusoid& one : law.sinusoids)
        written.sinusoids.push_back({to_double(one.amplitude), to_double(one.frequency), to_double(one.phase)});
    if (law.at(0).f != 0) written.polynomial.at(0) -= to_double(law.at(0).f);
    return written;
}

class Writer {
  public:
    explicit Writer(const Model& model) : model_(model) {
        for (const Body& body : model.bodies) starts_.push_back(body.start);
    }

    BodyData body(const Body& it) const {
        return {.name = it.name,
                .mass = to_double(it.mass),
                .inertia = data(it.J),
                .x = data(it.start.x),
                .R = data(it.start.R),
                .v = data(it.start.v),
                .omega = data(it.start.omega),
                .point = it.point};
    }
    JointData joint(const Joint& it) const {
        JointData written{.type = it.type->element.name, .between = between(it.first, it.second)};
        written.points = {place(it.first, it.r_first), place(it.second, it.r_second)};
        written.axes = {axis(it.first, it.axes_first), axis(it.second, it.axes_second)};
        if (it.length > 0) written.length = to_double(it.length);
        written.amplitude = to_double(it.amplitude), written.frequency = to_double(it.frequency);
        if (it.type->has(Primitive::turn)) written.turn = from_the_start(it.turn);
        if (it.type->has(Primitive::shift)) written.shift = from_the_start(it.shift);
        if (it.type->has(Primitive::mesh)) written.teeth = {it.teeth[0], it.teeth[1]};
        if (it.type->has(Primitive::helix)) written.lead = to_double(it.lead);
        return written;
    }
    ForceData spring(const Spring& it) const {
        return {.type = "spring",
                .between = between(it.first, it.second),
                .points = {place(it.first, it.r_first), place(it.second, it.r_second)},
                .stiffness = to_double(it.stiffness),
                .damping = to_double(it.damping),
                .rest = to_double(it.length)};
    }
    ForceData polynomial_spring(const PolynomialSpring& it) const {
        ForceData written{.type = "polynomial_spring",
                          .between = between(it.first, it.second),
                          .points = {place(it.first, it.r_first), place(it.second, it.r_second)},
                          .damping = to_double(it.damping),
                          .rest = to_double(it.length)};
        for (const Real& coefficient : it.coefficients) written.coefficients.push_back(to_double(coefficient));
        return written;
    }
    ForceData damper(const Damper& it) const {
        return {.type = "damper",
                .between = between(it.first, it.second),
                .damping = to_double(it.damping),
                .point = place(it.second, it.r_second)};
    }
    ForceData rotational_damper(const RotationalDamper& it) const {
        return {.type = "rotational_damper", .between = between(it.first, it.second), .damping = to_double(it.damping)};
    }
    void loads(const Load& it, std::vector<ForceData>& forces) const {
        ForceData written{.between = {"ground", model_.name_of(it.body)},
                          .body_axes = it.axes == Load::Axes::body,
                          .amplitude = to_double(it.amplitude),
                          .frequency = to_double(it.frequency)};
        written.type = "force", written.value = data(it.force), written.point = place(it.body, it.point);
        forces.push_back(written);
        written.type = "torque", written.value = data(it.torque), written.point.reset();
        forces.push_back(written);
    }

  private:
    std::array<std::string, 2> between(int first, int second) const {
        return {model_.name_of(first), model_.name_of(second)};
    }
    Vector3 place(int body, const Vec3& r) const { return data(motion_of(starts_, body).point(r)); }
    Vector3 axis(int body, const Mat3& axes) const {
        return data(Vec3(motion_of(starts_, body).direction(axes.col(2))));
    }

    const Model& model_;
    std::vector<BodyState> starts_;
};

}  // namespace

ParameterValues written(const Model& model) {
    const Writer write(model);
    std::vector<BodyData> bodies;
    std::vector<JointData> joints;
    std::vector<ForceData> forces;
    for (const Body& body : model.bodies) bodies.push_back(write.body(body));
    for (const Joint& joint : model.joints) joints.push_back(write.joint(joint));
    for (const Spring& spring : model.springs) forces.push_back(write.spring(spring));
    for (const PolynomialSpring& spring : model.polynomial_springs) forces.push_back(write.polynomial_spring(spring));
    for (const Damper& damper : model.dampers) forces.push_back(write.damper(damper));
    for (const RotationalDamper& damper : model.rotational_dampers) forces.push_back(write.rotational_damper(damper));
    for (const Load& load : model.loads) write.loads(load, forces);
    ParameterValues values = {{"bodies", bodies},
                              {"gravity", data(model.gravity.g)},
                              {"gravity_amplitude", to_double(model.gravity.amplitude)},
                              {"gravity_frequency", to_double(model.gravity.frequency)}};
    if (!joints.empty()) values["joints"] = joints;
    if (!forces.empty()) values["forces"] = forces;
    return values;
}

std::optional<Model> read_again(const Model& model) {
    if (!model.torsion_springs.empty()) return {};                         // their frames are more than an axis
    if (!model.bushings.empty() || !model.attractions.empty()) return {};  // numbers that are rounded when written
    const Problem& multibody = problem("multibody");
    ParameterValues values = written(model);
    for (const ParameterDescription& parameter : multibody.description.parameters)
        values.insert({parameter.name, parameter.standard});
    try {
        return multibody.build(Parameters(values));
    } catch (const ParameterError&) { return {}; }
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
