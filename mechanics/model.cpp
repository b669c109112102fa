// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cctype>
#include <sstream>

#include "lie/so3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::string text(double x) {
    std::ostringstream out;
    out.precision(10);
    out << x;
    return out.str();
}

Vec3 velocity_of_point(const BodyState& body, const Vec3& r) { return body.v + body.R * body.omega.cross(r); }

}  // namespace

void Model::join(int first, int second, const Vec3& point) {
    const auto local = [&](int body) -> Vec3 {
        if (body == ground) return point;
        const BodyState& start = bodies[static_cast<std::size_t>(body)].start;
        return start.R.transpose() * (point - start.x);
    };
    joints.push_back({first, second, local(first), local(second)});
}

Vec3 to_vec3(const Vector3& v) { return {decimal(v[0]), decimal(v[1]), decimal(v[2])}; }

namespace {

Mat3 to_mat3(const Matrix3& m) {
    Mat3 M;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) M(i, j) = decimal(m[static_cast<std::size_t>(3 * i + j)]);
    return M;
}

}  // namespace

Mat3 to_rotation(const Matrix3& m, const std::string& path) {
    Mat3 R = to_mat3(m);
    const Real defect = SO3::orthogonality_defect(R);
    if (!(defect < Real(1) / 1000000000) || R.determinant() <= 0)
        throw ParameterError(path, "expected a rotation matrix (R^T R = I, det R = 1), got |R^T R - I| = " +
                                       text(to_double(defect)) + ", det R = " + text(to_double(R.determinant())));
    // Newton's iteration for the polar factor: quadratic, so three steps take 1e-9 below any round-off used here.
    for (int i = 0; i < 3 && defect > 4 * epsilon; ++i) R = R * (3 * Mat3::Identity() - R.transpose() * R) / 2;
    return R;
}

Mat3 to_inertia(const Matrix3& m, const std::string& path, TriangleInequality rule, std::vector<std::string>& warnings) {
    const Mat3 J = to_mat3(m);
    if (J != J.transpose()) throw ParameterError(path, "expected a symmetric inertia matrix");
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(J, Eigen::EigenvaluesOnly);
    const Vec3 moments = principal.eigenvalues();  // in increasing order
    const std::string got = "got principal moments " + text(to_double(moments[0])) + ", " + text(to_double(moments[1])) +
                            ", " + text(to_double(moments[2])) + " kg m^2";
    if (!(moments[0] > 0)) throw ParameterError(path, "expected a positive definite inertia, " + got);
    const Real slack = Real(1) / 1000000000000;
    if (moments[0] + moments[1] < moments[2] * (1 - slack)) {
        const std::string what = "no body has this inertia: each principal moment is at most the sum of the others, " + got;
        if (rule == TriangleInequality::required) throw ParameterError(path, what);
        warnings.push_back(what);
    }
    return J;
}

const std::string& to_name(const std::string& name, const std::string& path) {
    const auto allowed = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
    if (name.empty() || name == "ground" || !std::all_of(name.begin(), name.end(), allowed))
        throw ParameterError(path, "expected a name of letters, digits, _ and - other than \"ground\", got \"" + name + "\"");
    return name;
}

Real to_mass(double mass, const std::string& path) {
    if (!(mass > 0)) throw ParameterError(path, "expected a positive mass in kg, got " + text(mass));
    return decimal(mass);
}

void complete_velocities(Model& model, const std::vector<bool>& given) {
    const auto bodies = static_cast<Eigen::Index>(model.bodies.size());
    const auto joints = static_cast<Eigen::Index>(model.joints.size());
    // Rows of the joints in the unknown velocities; known velocities and all rotations go to the right-hand side.
    MatX C = MatX::Zero(3 * joints, 3 * bodies);
    VecX rhs = VecX::Zero(3 * joints);
    for (std::size_t i = 0; i < given.size(); ++i)
        if (!given[i]) model.bodies[i].start.v.setZero();
    const auto add = [&](Eigen::Index row, int body, const Vec3& r, int sign) {
        if (body == ground) return;
        const auto i = static_cast<std::size_t>(body);
        if (!given[i]) C.block<3, 3>(row, 3 * body) = sign * Mat3::Identity();
        rhs.segment<3>(row) -= sign * velocity_of_point(model.bodies[i].start, r);
    };
    for (Eigen::Index j = 0; j < joints; ++j) {
        const SphericalJoint& joint = model.joints[static_cast<std::size_t>(j)];
        add(3 * j, joint.first, joint.r_first, 1);
        add(3 * j, joint.second, joint.r_second, -1);
    }
    const VecX v = C.completeOrthogonalDecomposition().solve(rhs);
    for (std::size_t i = 0; i < given.size(); ++i)
        if (!given[i]) model.bodies[i].start.v = v.segment<3>(3 * static_cast<Eigen::Index>(i));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
