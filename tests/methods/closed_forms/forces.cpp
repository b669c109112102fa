// SPDX-License-Identifier: BSD-3-Clause
//
// Motions under one force whose solution is known in closed form, by rkmk/rk4 in every formulation that takes them.
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <functional>

#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

/// A body with moments 2, 3, 4 (kg m^2) in its own axes.
Body body_at(const std::string& name, const Vec3& x, const Vec3& v, const Vec3& omega = Vec3::Zero()) {
    Body body{.name = name, .mass = Real(3) / 2, .J = Vec3(2, 3, 4).asDiagonal()};
    body.start.x = x, body.start.v = v, body.start.omega = omega;
    return body;
}

using Exact = std::function<std::vector<BodyState>(const Real& t)>;

/// Error at t_end with so many steps, over all quantities.
Real miss(const Model& model, const std::string& formulation, const Exact& exact, const Real& t_end, long steps) {
    Trip trip(model, formulation, method("rkmk/rk4"));
    REQUIRE(trip.run(t_end, steps) == Status::ok);
    return worst(distance(exact(t_end), trip.bodies()));
}

/// Errors are small and fall by 2^4 as h is halved.
void require_closed_form(const Model& model, const Exact& exact, const Real& t_end) {
    for (const std::string& formulation : applicable(model)) {
        const Real coarse = miss(model, formulation, exact, t_end, 200);
        const Real fine = miss(model, formulation, exact, t_end, 400);
        CAPTURE(formulation, coarse, fine);
        CHECK(fine < Real(1) / 100000);
        if (coarse > 100000 * epsilon) CHECK((coarse > 12 * fine && coarse < 24 * fine));
    }
}

BodyState like(const Body& body, const Vec3& x, const Vec3& v) {
    BodyState state = body.start;
    state.x = x, state.v = v;
    return state;
}

/// A Kepler orbit of semi-axis 1 and eccentricity e about the origin, from its near point in the plane of x and y:
/// x = cos E - e, y = sqrt(1 - e^2) sin E with E - e sin E = sqrt(mu) t.
struct Orbit {
    Real e, mu;
    Vec3 x(const Real& E) const { return Vec3(cos(E) - e, sqrt(1 - e * e) * sin(E), 0); }
    Vec3 v(const Real& E) const { return sqrt(mu) / (1 - e * cos(E)) * Vec3(-sin(E), sqrt(1 - e * e) * cos(E), 0); }
    Real anomaly(const Real& t) const {
        Real E = sqrt(mu) * t;
        for (int i = 0; i < 50; ++i) E -= (E - e * sin(E) - sqrt(mu) * t) / (1 - e * cos(E));
        return E;
    }
};

/// The vector of Laplace, Runge and Lenz, which points to the near point and has the length e.
Vec3 eccentricity(const BodyState& s, const Real& mu) { return s.v.cross(s.x.cross(s.v)) / mu - s.x.normalized(); }

const Orbit ellipse{Real(3) / 10, Real(2)};

Model satellite() {
    Model model;
    model.bodies.push_back(body_at("satellite", ellipse.x(0), ellipse.v(0)));
    model.attractions.push_back({.second = 0, .strength = ellipse.mu * model.bodies[0].mass});
    return model;
}

}  // namespace

TEST_CASE("a body in a central field moves on Kepler's ellipse, which keeps its shape and direction", "[forces]") {
    const Model model = satellite();
    require_closed_form(
        model,
        [&](const Real& t) -> std::vector<BodyState> {
            const Real E = ellipse.anomaly(t);
            return {like(model.bodies[0], ellipse.x(E), ellipse.v(E))};
        },
        4);
    Trip trip(model, "SO3xR3", method("rkmk/rk4"));
    REQUIRE(trip.run(20, 4000) == Status::ok);
    CHECK((eccentricity(trip.bodies()[0], ellipse.mu) - Vec3(ellipse.e, 0, 0)).norm() < Real(1) / 10000000);
}

TEST_CASE("two bodies that attract each other move on ellipses about their mass centre", "[forces]") {
    Model model;
    model.bodies = {body_at("one", Vec3::Zero(), Vec3::Zero()), body_at("other", Vec3::Zero(), Vec3::Zero())};
    model.bodies[1].mass = Real(1) / 2;
    const Real m1 = model.bodies[0].mass, m2 = model.bodies[1].mass, m = m1 + m2, G = ellipse.mu / m;
    model.attractions.push_back({.first = 0, .second = 1, .strength = G * m1 * m2});
    const Exact exact = [&](const Real& t) -> std::vector<BodyState> {
        const Real E = ellipse.anomaly(t);
        const Vec3 d = ellipse.x(E), rate = ellipse.v(E);
        return {like(model.bodies[0], -m2 / m * d, -m2 / m * rate), like(model.bodies[1], m1 / m * d, m1 / m * rate)};
    };
    const std::vector<BodyState> start = exact(0);
    model.bodies[0].start = start[0], model.bodies[1].start = start[1];
    require_closed_form(model, exact, 4);
}

TEST_CASE("a body on a bushing is three oscillators, and turns about each of its axes as another", "[forces]") {
    const Vec3 k(3, 5, 8), torsion(6, 7, 9);
    Model model;
    model.bodies.push_back(body_at("body", Vec3(1, -2, Real(1) / 2), Vec3::Zero()));
    model.bushings.push_back({.second = 0, .stiffness = {k, torsion}});
    const Body& body = model.bodies[0];
    const Vec3 x0 = body.start.x;
    require_closed_form(
        model,
        [&](const Real& t) -> std::vector<BodyState> {
            Vec3 x, v;
            for (Eigen::Index i = 0; i < 3; ++i) {
                const Real w = sqrt(k[i] / body.mass);
                x[i] = x0[i] * cos(w * t), v[i] = -x0[i] * w * sin(w * t);
            }
            return {like(body, x, v)};
        },
        3);
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Real rate = Real(3) / 2, w = sqrt(torsion[i] / body.J(i, i));
        const Vec3 axis = Vec3::Unit(i);
        Model turning = model;
        turning.bodies[0].start.x.setZero(), turning.bodies[0].start.omega = rate * axis;
        require_closed_form(
            turning,
            [&](const Real& t) -> std::vector<BodyState> {
                return {{Vec3::Zero(), SO3::exp(rate / w * sin(w * t) * axis), Vec3::Zero(), rate * cos(w * t) * axis}};
            },
            3);
    }
}

TEST_CASE("dampers slow a body exponentially", "[forces]") {
    const Real c = 2, r = 3, rate = Real(5) / 4;
    const Vec3 v0(1, -2, 3), axis = Vec3::UnitZ();
    Model model;
    model.bodies.push_back(body_at("body", Vec3(3, 1, 2), v0, rate * axis));
    model.dampers.push_back({.second = 0, .damping = c});
    model.rotational_dampers.push_back({.second = 0, .damping = r});
    const Real a = c / model.bodies[0].mass, b = r / model.bodies[0].J(2, 2);
    require_closed_form(
        model,
        [&](const Real& t) -> std::vector<BodyState> {
            const Vec3 x = model.bodies[0].start.x + (1 - exp(-a * t)) / a * v0;
            return {{x, SO3::exp(rate * (1 - exp(-b * t)) / b * axis), exp(-a * t) * v0, rate * exp(-b * t) * axis}};
        },
        2);
}

/// x'' = -c_1 x - c_3 x^3 from rest at A: x = A cn(w t, k) with w^2 = c_1 + c_3 A^2 and 2 k^2 w^2 = c_3 A^2 (per mass).
TEST_CASE("a spring with a cubic law is Duffing's oscillator", "[forces]") {
    if (KREISEL_QUAD) return;  // the elliptic functions are computed in double
    const double linear = 4, cubic = 3, amplitude = 0.75;
    Model model;
    model.bodies.push_back(body_at("body", Vec3(amplitude, 0, 0), Vec3::Zero()));
    const double mass = to_double(model.bodies[0].mass), w = std::sqrt((linear + cubic * amplitude * amplitude) / mass);
    const double k = std::sqrt(cubic * amplitude * amplitude / 2 / mass) / w;
    PolynomialSpring spring;
    spring.second = 0, spring.r_first = Vec3(-3, 0, 0), spring.length = 3, spring.coefficients = {linear, 0, cubic};
    model.polynomial_springs.push_back(spring);
    require_closed_form(
        model,
        [&](const Real& t) -> std::vector<BodyState> {
            double cn = 0, dn = 0;
            const double sn = boost::math::jacobi_elliptic(k, w * to_double(t), &cn, &dn);
            return {like(model.bodies[0], Vec3(amplitude * cn, 0, 0), Vec3(-amplitude * w * sn * dn, 0, 0))};
        },
        3);
}

TEST_CASE("a dead load has an energy, and others have none", "[forces]") {
    Model model;
    model.bodies.push_back(body_at("body", Vec3(1, 2, 3), Vec3(0, 1, 0), Vec3(1, -2, 1)));
    model.loads.push_back({.body = 0, .force = Vec3(2, -1, 3), .point = Vec3(1, 1, -1) / 2});
    const auto energy = [](const System& system, const std::vector<BodyState>& bodies) -> std::optional<Real> {
        for (const FirstIntegral& integral : system.integrals())
            if (integral.name == "energy") return integral.value({bodies, {}});
        return {};
    };
    Trip trip(model, "SO3xR3", method("rkmk/rk4"));
    const auto before = energy(*trip.system, trip.bodies());
    REQUIRE(trip.run(1, 400) == Status::ok);
    const auto after = energy(*trip.system, trip.bodies());
    REQUIRE((before && after));
    CHECK(abs(*after - *before) < Real(1) / 10000000);
    CHECK(abs(trip.bodies()[0].v.squaredNorm() - 1) > 1);  // it is the load that does work
    for (const auto& change : std::vector<std::function<void(Load&)>>{
             [](Load& load) { load.axes = Load::Axes::body; }, [](Load& load) { load.torque[0] = 1; },
             [](Load& load) { load.amplitude = 1, load.frequency = 1; }}) {
        Model other = model;
        change(other.loads[0]);
        CHECK_FALSE(energy(*make_system(other, "SO3xR3"), trip.bodies()));
    }
}

TEST_CASE("control: a closed form with another constant is not met", "[forces]") {
    Model model = satellite();
    model.attractions[0].strength *= 1 + Real(1) / 1000;
    const Real E = ellipse.anomaly(4);
    const Exact exact = [&](const Real&) -> std::vector<BodyState> {
        return {like(model.bodies[0], ellipse.x(E), ellipse.v(E))};
    };
    CHECK(miss(model, "SO3xR3", exact, 4, 400) > Real(1) / 10000);
}
