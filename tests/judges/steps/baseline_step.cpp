// SPDX-License-Identifier: BSD-3-Clause
//
// The baselines against the classical fourth-order method derived here independently, with coordinates of rotations by
// other formulas than theirs: Eigen's quaternions, products of matrices, products of three rotations about axes.
#include "tests/judges/steps/baseline_step.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "tests/judges/steps/recorded_steps.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Coordinates z of a 3x3 matrix R, and z' for R' = R hat(w).
struct Coordinates {
    std::function<VecX(const Mat3&)> read;
    std::function<Mat3(const VecX&)> matrix;
    std::function<VecX(const VecX&, const Vec3&)> rate;
    std::function<VecX(const VecX&)> finish = [](const VecX& z) { return z; };
};

Mat3 hat(const Vec3& w) {
    Mat3 W;
    W << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
    return W;
}

Coordinates entries() {
    return {.read = [](const Mat3& R) -> VecX { return Eigen::Map<const VecX>(R.data(), 9); },
            .matrix = [](const VecX& z) -> Mat3 { return Eigen::Map<const Mat3>(z.data()); },
            .rate = [](const VecX& z, const Vec3& w) -> VecX {
                const Mat3 dR = Eigen::Map<const Mat3>(z.data()) * hat(w);
                return Eigen::Map<const VecX>(dR.data(), 9);
            }};
}

using Quaternion = Eigen::Quaternion<Real>;

/// R = |q|^2 times the rotation of q/|q|.
Coordinates quaternion(bool renormalise) {
    return {.read = [](const Mat3& R) -> VecX {
                const Real squared_norm = R.col(0).norm();
                return sqrt(squared_norm) * Quaternion(Mat3(R / squared_norm)).coeffs();
            },
            .matrix = [](const VecX& z) -> Mat3 {
                const Quaternion q{Eigen::Matrix<Real, 4, 1>(z)};
                return q.squaredNorm() * q.normalized().toRotationMatrix();
            },
            .rate = [](const VecX& z, const Vec3& w) -> VecX {
                const Quaternion q{Eigen::Matrix<Real, 4, 1>(z)};
                return (q * Quaternion(0, w[0], w[1], w[2])).coeffs() / 2;
            },
            .finish = [renormalise](const VecX& z) -> VecX { return renormalise ? VecX(z / z.norm()) : z; }};
}

Mat3 about(int axis, const Real& angle) { return dense_exp(hat(angle * Vec3(Vec3::Unit(axis)))); }

/// R = R_z(psi) R_x(theta) R_y(phi). Each angle turns about its axis, seen from the axes after it.
Coordinates euler_angles() {
    return {.read = [](const Mat3& R) -> VecX {
                return Vec3(atan2(-R(0, 1), R(1, 1)), asin(R(2, 1)), atan2(-R(2, 0), R(2, 2)));
            },
            .matrix = [](const VecX& z) -> Mat3 { return about(2, z[0]) * about(0, z[1]) * about(1, z[2]); },
            .rate = [](const VecX& z, const Vec3& w) -> VecX {
                Mat3 axes;
                const Mat3 last = about(1, z[2]), two = about(0, z[1]) * last;
                axes << two.transpose().col(2), last.transpose().col(0), Vec3::Unit(1);
                return axes.partialPivLu().solve(w);
            }};
}

/// The state of all bodies as one vector: positions and coordinates body by body, then velocities.
class GlobalState {
  public:
    GlobalState(System& system, const Coordinates& z)
        : system_(system), z_(z), lead_(system.group().dim() == 6 * system.bodies() ? 3 : 0) {}

    VecX read(const VecX& y) const {
        VecX w(0);
        for (int i = 0; i < system_.bodies(); ++i) {
            const VecX body = y.segment(i * (lead_ + 9), lead_ + 9);
            append(w, body.head(lead_));
            append(w, z_.read(Mat3(Eigen::Map<const Mat3>(body.data() + lead_))));
        }
        append(w, y.tail(system_.velocities()));
        return w;
    }

    VecX write(const VecX& w, bool finished) const {
        VecX y(0);
        for (int i = 0; i < system_.bodies(); ++i) {
            const VecX body = segment(w, i), z = body.tail(body.size() - lead_);
            const Mat3 R = z_.matrix(finished ? z_.finish(z) : z);
            append(y, body.head(lead_));
            append(y, Eigen::Map<const VecX>(R.data(), 9));
        }
        append(y, w.tail(system_.velocities()));
        return y;
    }

    VecX rate(const Real& t, const VecX& w) const {
        const VecX y = write(w, false), v = w.tail(system_.velocities());
        VecX dv(v.size()), dw(0);
        const Status status = system_.accelerations(t, y.data(), system_.v(y.data()), dv.data(), nullptr);
        if (status != Status::ok) throw std::domain_error(std::string("the dynamics end in ") + name(status));
        for (int i = 0; i < system_.bodies(); ++i) {
            const VecX body = segment(w, i), vi = v.segment(i * (lead_ + 3), lead_ + 3);
            append(dw, vi.head(lead_));
            append(dw, z_.rate(body.tail(body.size() - lead_), Vec3(vi.tail(3))));
        }
        append(dw, dv);
        return dw;
    }

  private:
    static void append(VecX& all, const VecX& more) {
        VecX joined(all.size() + more.size());
        joined << all, more;
        all = joined;
    }
    VecX segment(const VecX& w, int body) const {
        const Eigen::Index size = (w.size() - system_.velocities()) / system_.bodies();
        return w.segment(body * size, size);
    }

    System& system_;
    const Coordinates& z_;
    int lead_;  // numbers of a body's position
};

/// [kutta1901].
VecX classical_step(const GlobalState& state, const Real& t, const Real& h, const VecX& w) {
    const VecX k1 = state.rate(t, w), k2 = state.rate(t + h / 2, w + h / 2 * k1);
    const VecX k3 = state.rate(t + h / 2, w + h / 2 * k2), k4 = state.rate(t + h, w + h * k3);
    return w + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

/// `stretch` times the rotations of the start: what the coordinates keep off SO(3) must survive a step.
Objection baseline_objection(const Method& method, const OptionValues& options, const Coordinates& z,
                             const Real& stretch) {
    const auto check = [&](const std::string& problem, const std::string& formulation) -> Objection {
        stepping::Trip trip(models::standard(problem), formulation, method, options);
        const Eigen::Map<VecX> y(trip.y.data(), static_cast<Eigen::Index>(trip.y.size()));
        const int body = static_cast<int>(trip.system->group().size()) / trip.system->bodies();
        for (int i = 1; i <= trip.system->bodies(); ++i) Eigen::Map<VecX>(trip.y.data() + i * body - 9, 9) *= stretch;
        const GlobalState state(*trip.system, z);
        const Real t = Real(1) / 3, h = Real(1) / 8;
        const VecX expected = state.write(classical_step(state, t, h, state.read(y)), true);
        if (const Status status = trip.integrator->step(t, h, trip.y.data()); status != Status::ok)
            return std::string("the step ends in ") + name(status);
        Violations found;
        found.see("the classical step", VecX(y) - expected);
        return found.objection(1000 * epsilon * max(Real(1), expected.cwiseAbs().maxCoeff()));
    };
    for (const char* name : {"forced_heavy_top", "forced_free_body", "double_pendulum"})
        for (const std::string& formulation : models::applicable(models::standard(name))) {
            if (!stepping::runs_on(method.description, formulation)) continue;
            const Objection objection = check(name, formulation);
            if (!objection.empty()) return objection + " on " + name + " as " + formulation;
        }
    return "";
}

}  // namespace

Objection quaternion_step_objection(const Method& method) {
    for (const bool renormalise : {true, false}) {
        const Objection objection =
            baseline_objection(method, {{"renormalise", renormalise}}, quaternion(renormalise), Real(5) / 4);
        if (!objection.empty()) return objection + (renormalise ? ", renormalised" : "");
    }
    return "";
}

Objection matrix_step_objection(const Method& method) { return baseline_objection(method, {}, entries(), Real(5) / 4); }

Objection euler_angles_step_objection(const Method& method) {
    return baseline_objection(method, {}, euler_angles(), 1);
}

namespace {

const char* const tableau_of_odeint = "the tableau is in Boost.Odeint; steps are compared with the classical method";

}  // namespace

KREISEL_STEP_CHECK("baseline/rk4_quaternion", quaternion_step_objection, tableau_of_odeint);
KREISEL_STEP_CHECK("baseline/rk4_matrix", matrix_step_objection, tableau_of_odeint);
KREISEL_STEP_CHECK("baseline/rk4_euler_angles", euler_angles_step_objection, tableau_of_odeint);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
