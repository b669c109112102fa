// SPDX-License-Identifier: BSD-3-Clause
//
// The N-fold spherical pendulum of the literature [celledoni2022, Sec. 4.3: N = 2, ..., 20, end at 3 s] against its
// equations in Cartesian coordinates, which involve neither bodies nor groups: with r_i = x_i - x_{i-1} and the
// tensions T_i along them,
//   m x_i'' = m g - T_i r_i + T_{i+1} r_{i+1},   r_i . r_i'' + |r_i'|^2 = 0.
#include <Eigen/LU>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

using Points = std::vector<double>;  // x_1, ..., x_N, x_1', ..., x_N'

/// Masses of 1 kg.
class CartesianChain {
  public:
    explicit CartesianChain(int N) : N_(N) {}

    void operator()(const Points& y, Points& dy, double) const {
        Eigen::MatrixXd S = Eigen::MatrixXd::Zero(N_, N_);
        Eigen::VectorXd rhs(N_);
        const Eigen::Vector3d g(0, 0, -9.81);
        for (int i = 0; i < N_; ++i) {
            S(i, i) = (i == 0 ? 1 : 2) * rod(y, 0, i).squaredNorm();
            if (i > 0) S(i, i - 1) = S(i - 1, i) = -rod(y, 0, i).dot(rod(y, 0, i - 1));
            rhs[i] = rod(y, 1, i).squaredNorm() + (i == 0 ? g.dot(rod(y, 0, 0)) : 0);
        }
        const Eigen::VectorXd T = S.partialPivLu().solve(rhs);
        for (int i = 0; i < N_; ++i) {
            const Eigen::Vector3d next =
                i + 1 < N_ ? Eigen::Vector3d(T[i + 1] * rod(y, 0, i + 1)) : Eigen::Vector3d::Zero();
            const Eigen::Vector3d velocity = point(y, 1, i), acceleration = g - T[i] * rod(y, 0, i) + next;
            std::copy_n(velocity.data(), 3, dy.begin() + 3 * i);
            std::copy_n(acceleration.data(), 3, dy.begin() + 3 * (N_ + i));
        }
    }

    Eigen::Vector3d point(const Points& y, int level, int i) const {
        return Eigen::Map<const Eigen::Vector3d>(&y[static_cast<std::size_t>(3 * (level * N_ + i))]);
    }

  private:
    Eigen::Vector3d rod(const Points& y, int level, int i) const {
        return i == 0 ? point(y, level, 0) : Eigen::Vector3d(point(y, level, i) - point(y, level, i - 1));
    }

    int N_;
};

/// The points at t_end, released at rest along x with rods of 5/N m.
Points cartesian_motion(int N, double t_end, int steps) {
    Points y(static_cast<std::size_t>(6 * N), 0.0);
    for (int i = 0; i < N; ++i) y[static_cast<std::size_t>(3 * i)] = 5.0 * (i + 1) / N;
    boost::numeric::odeint::runge_kutta_fehlberg78<Points> stepper;
    const CartesianChain chain(N);
    for (int k = 0; k < steps; ++k) stepper.do_step(chain, y, t_end * k / steps, t_end / steps);
    return y;
}

}  // namespace

TEST_CASE("the N-fold pendulum of the literature satisfies its Cartesian equations", "[methods][published]") {
    if (KREISEL_QUAD) return;  // the equations here are in double
    for (const int N : {2, 3, 5, 10, 20}) {
        const Points expected = cartesian_motion(N, 3, 6000);
        ParameterValues values = defaults(problem("spherical_pendulum_chain"));
        values["masses"] = static_cast<double>(N);
        Trip trip(problem("spherical_pendulum_chain").build(Parameters(values)), "SO3xR3", method("rkmk/rk4"),
                  "position_velocity");
        REQUIRE(trip.run(3, 6000) == Status::ok);
        const CartesianChain chain(N);
        for (int i = 0; i < N; ++i) {
            INFO("mass " << i + 1 << " of " << N);
            const Vec3 x = trip.bodies()[static_cast<std::size_t>(i)].x;
            const Eigen::Vector3d position(to_double(x[0]), to_double(x[1]), to_double(x[2]));
            CHECK((position - chain.point(expected, 0, i)).norm() <= 1e-8);
        }
    }
}
