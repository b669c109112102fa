// SPDX-License-Identifier: BSD-3-Clause
//
// A step of Odeint's Runge-Kutta pairs against their tableaus [hairer1993, Table II.5.2, Sec. II.10], in coordinates
// coded independently: the quaternions of Eigen.
#include <Eigen/Geometry>

#include "methods/tableaus/bound_tableau.hpp"
#include "tests/peers/methods/approach.hpp"

using namespace kreisel;
using namespace peers;

namespace {

const Tableau dormand_prince = {
    .a = {{},
          {{1, 5}},
          {{3, 40}, {9, 40}},
          {{44, 45}, {-56, 15}, {32, 9}},
          {{19372, 6561}, {-25360, 2187}, {64448, 6561}, {-212, 729}},
          {{9017, 3168}, {-355, 33}, {46732, 5247}, {49, 176}, {-5103, 18656}}},
    .b = {{35, 384}, 0, {500, 1113}, {125, 192}, {-2187, 6784}, {11, 84}},
};

const Tableau fehlberg = {
    .a = {{},
          {{2, 27}},
          {{1, 36}, {1, 12}},
          {{1, 24}, 0, {1, 8}},
          {{5, 12}, 0, {-25, 16}, {25, 16}},
          {{1, 20}, 0, 0, {1, 4}, {1, 5}},
          {{-25, 108}, 0, 0, {125, 108}, {-65, 27}, {125, 54}},
          {{31, 300}, 0, 0, 0, {61, 225}, {-2, 9}, {13, 900}},
          {2, 0, 0, {-53, 6}, {704, 45}, {-107, 9}, {67, 90}, 3},
          {{-91, 108}, 0, 0, {23, 108}, {-976, 135}, {311, 54}, {-19, 60}, {17, 6}, {-1, 12}},
          {{2383, 4100}, 0, 0, {-341, 164}, {4496, 1025}, {-301, 82}, {2133, 4100}, {45, 82}, {45, 164}, {18, 41}},
          {{3, 205}, 0, 0, 0, 0, {-6, 41}, {-3, 205}, {-3, 41}, {3, 41}, {6, 41}, 0},
          {{-1777, 4100},
           0,
           0,
           {-341, 164},
           {4496, 1025},
           {-289, 82},
           {2193, 4100},
           {51, 82},
           {33, 164},
           {12, 41},
           0,
           1}},
    .b = {0, 0, 0, 0, 0, {34, 105}, {9, 35}, {9, 35}, {9, 280}, {9, 280}, 0, {41, 840}, {41, 840}},
};

/// w = (quaternion as Eigen stores it, omega) of a top about its pivot.
using Top = Eigen::Matrix<Real, 7, 1>;
using EigenQuaternion = Eigen::Quaternion<Real>;

std::vector<Real> state_of(const Top& w) {
    const EigenQuaternion q{Eigen::Matrix<Real, 4, 1>(w.head<4>())};
    std::vector<Real> y(12);
    Eigen::Map<Mat3>(y.data()) = q.normalized().toRotationMatrix();
    Eigen::Map<Vec3>(y.data() + 9) = w.tail<3>();
    return y;
}

Top rate(System& system, const Real& t, const Top& w) {
    const std::vector<Real> y = state_of(w);
    const EigenQuaternion q{Eigen::Matrix<Real, 4, 1>(w.head<4>())};
    Vec3 domega;
    REQUIRE(system.accelerations(t, y.data(), y.data() + 9, domega.data(), nullptr) == Status::ok);
    Top dw;
    dw << (q * EigenQuaternion(0, w[4], w[5], w[6])).coeffs() / 2, domega;
    return dw;
}

Top runge_kutta(System& system, const Tableau& tableau, const Real& t, const Real& h, const Top& w) {
    std::vector<Top> k;
    Top end = w;
    for (std::size_t i = 0; i < tableau.a.size(); ++i) {
        Top stage = w;
        Real c = 0;
        for (std::size_t j = 0; j < i; ++j) {
            stage += h * value(tableau.a[i][j]) * k[j];
            c += value(tableau.a[i][j]);
        }
        k.push_back(rate(system, t + c * h, stage));
        end += h * value(tableau.b[i]) * k[i];
    }
    return end;
}

/// Largest difference of an entry between the first step of a baseline and that of a tableau.
Real deviation(const std::string& name, const Tableau& tableau) {
    const Model model = models::standard("forced_heavy_top");
    Approach run(model, "SO3", method(name), {}, Real(1) / 10000);
    const std::vector<Real> start = run.y;
    Top w;
    w << EigenQuaternion(Mat3(Eigen::Map<const Mat3>(start.data()))).coeffs(), Eigen::Map<const Vec3>(&start[9]);
    REQUIRE(run.stepper->start(0, 1, run.y.data()) == Status::ok);
    REQUIRE(run.stepper->step(run.t, 1, run.y.data()) == Status::ok);
    REQUIRE(run.t > Real(1) / 100);
    const std::vector<Real> expected = state_of(runge_kutta(*run.system, tableau, 0, run.t, w));
    Real apart = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) apart = max(apart, Real(abs(run.y[i] - expected[i])));
    return apart;
}

}  // namespace

TEST_CASE("steps of Odeint's pairs are those of their tableaus", "[peers]") {
    CHECK(deviation("baseline/odeint_dopri5", dormand_prince) <= 100 * epsilon);
    CHECK(deviation("baseline/odeint_rkf78", fehlberg) <= 100 * epsilon);
}

TEST_CASE("control: the tableau of another pair is seen", "[peers][control]") {
    CHECK(deviation("baseline/odeint_dopri5", fehlberg) > 1000 * epsilon);
    Tableau changed = fehlberg;
    changed.a[12][3] = {-341, 165};
    CHECK(deviation("baseline/odeint_rkf78", changed) > 1000 * epsilon);
}
