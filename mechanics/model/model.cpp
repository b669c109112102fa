// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/model/model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <set>

#include "lie/so3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Ten digits. Not by a stream, which would take longer than all else of a small model.
std::string text(double x) {
    char digits[32];
    return {digits, std::to_chars(digits, std::end(digits), x, std::chars_format::general, 10).ptr};
}

}  // namespace

Vec3 Model::point_of(int body, const Vec3& point) const {
    if (body == ground) return point;
    const BodyState& start = bodies[static_cast<std::size_t>(body)].start;
    return start.R.transpose() * (point - start.x);
}

Mat3 Model::axes_of(int body, const Mat3& axes) const {
    if (body == ground) return axes;
    return bodies[static_cast<std::size_t>(body)].start.R.transpose() * axes;
}

void Model::join(int first, int second, const Vec3& point, JointType type, const Vec3& axis) {
    const Mat3 axes = axes_about(axis);
    joints.push_back({.first = first,
                      .second = second,
                      .r_first = point_of(first, point),
                      .r_second = point_of(second, point),
                      .type = type,
                      .axes_first = axes_of(first, axes),
                      .axes_second = axes_of(second, axes)});
}

std::string Model::name_of(int body) const {
    return body == ground ? "ground" : bodies[static_cast<std::size_t>(body)].name;
}

std::string Model::name_of_joint(std::size_t joint) const {
    const Joint& j = joints[joint];
    return "joint " + std::to_string(joint) + " (" + name_of(j.first) + " - " + name_of(j.second) + ", " +
           j.type.name() + ")";
}

std::vector<std::string> Model::joint_names() const {
    std::set<std::string> taken;
    for (const Joint& joint : joints) taken.insert(joint.name);
    std::vector<std::string> names;
    for (const Joint& joint : joints) {
        std::string name = joint.name;
        const std::string bodies_of_it = name_of(joint.first) + "-" + name_of(joint.second);
        for (int i = 1; name.empty() || (joint.name.empty() && !taken.insert(name).second); ++i)
            name = bodies_of_it + (i == 1 ? "" : "-" + std::to_string(i));
        names.push_back(name);
    }
    return names;
}

std::string Model::name_of_torsion_spring(std::size_t spring) const {
    const TorsionSpring& s = torsion_springs[spring];
    return "torsion spring " + std::to_string(spring) + " (" + name_of(s.first) + " - " + name_of(s.second) + ")";
}

Mat3 axes_about(const Vec3& axis) {
    // Scaling each component by the largest keeps squares of tiny or huge axes in range.
    const Vec3 e = Vec3(axis / axis.lpNorm<Eigen::Infinity>()).normalized();
    Eigen::Index least = 0;
    e.cwiseAbs().minCoeff(&least);
    Mat3 axes;
    axes.col(2) = e;
    axes.col(0) = e.cross(Vec3::Unit(least)).normalized();
    axes.col(1) = e.cross(axes.col(0));
    return axes;
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

Mat3 to_inertia(const Matrix3& m, const std::string& path, TriangleInequality rule,
                std::vector<std::string>& warnings) {
    const Mat3 J = to_mat3(m);
    if (J != J.transpose()) throw ParameterError(path, "expected a symmetric inertia matrix");
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(J, Eigen::EigenvaluesOnly);
    const Vec3& moments = principal.eigenvalues();  // in increasing order
    const auto got = [&] {
        return "got principal moments " + text(to_double(moments[0])) + ", " + text(to_double(moments[1])) + ", " +
               text(to_double(moments[2])) + " kg m^2";
    };
    if (!(moments[0] > 0)) throw ParameterError(path, "expected a positive definite inertia, " + got());
    const Real slack = Real(1) / 1000000000000;
    if (moments[0] + moments[1] < moments[2] * (1 - slack)) {
        const std::string what =
            "no body has this inertia: each principal moment is at most the sum of the others, " + got();
        if (rule == TriangleInequality::required) throw ParameterError(path, what);
        warnings.push_back(what);
    }
    return J;
}

const std::string& to_name(const std::string& name, const std::string& path) {
    const auto allowed = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
    if (name.empty() || name == "ground" || !std::all_of(name.begin(), name.end(), allowed))
        throw ParameterError(path,
                             "expected a name of letters, digits, _ and - other than \"ground\", got \"" + name + "\"");
    return name;
}

Real to_mass(double mass, const std::string& path) {
    if (!(mass > 0)) throw ParameterError(path, "expected a positive mass in kg, got " + text(mass));
    return decimal(mass);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
