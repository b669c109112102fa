// SPDX-License-Identifier: BSD-3-Clause
//
// Dense output meets the ends of a step and has its order in between, measured against fine steps.
#include "methods/control/interpolant.hpp"

#include "methods/simulation.hpp"
#include "tests/methods/stepping.hpp"

using namespace stepping;

namespace {

/// The state after t, far more accurate than any interpolant below.
std::vector<Real> exact(const std::string& formulation, const Real& t) {
    Simulation simulation(models::standard("forced_heavy_top"), {.formulation = formulation});
    if (t > 0) REQUIRE(simulation.advance(t, KREISEL_QUAD ? 4096 : 256) == Status::ok);
    return simulation.state();
}

/// A system whose accelerations are wrong by a factor of 1 + 1/100.
class WrongAccelerations final : public System {
  public:
    explicit WrongAccelerations(System& inner)
        : System(std::shared_ptr<const Group>(std::shared_ptr<void>(), &inner.group())), inner_(inner) {}
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        const Status status = inner_.accelerations(t, q, v, dv, lambda);
        for (int i = 0; i < velocities(); ++i) dv[i] += dv[i] / 100;
        return status;
    }

  private:
    System& inner_;
};

/// |log(a^-1 b)| of configurations and of velocities.
std::pair<double, double> distances(const TangentGroup& group, std::vector<Real> a, const std::vector<Real>& b) {
    group.inverse(a.data(), a.data());
    group.multiply(a.data(), b.data(), a.data());
    VecX u(group.dim());
    group.log(a.data(), u.data());
    return {to_double(u.head(group.dim() / 2).norm()), to_double(u.tail(group.dim() / 2).norm())};
}

/// Errors of configuration and velocity in the middle of steps by h and h/2 from t = 1/4: their ratios as orders.
std::pair<double, double> observed(System& system, const std::string& formulation) {
    const TangentGroup& group = system.state_group();
    const auto error = [&](const Real& h) {
        const std::vector<Real> y0 = exact(formulation, Real(1) / 4), y1 = exact(formulation, Real(1) / 4 + h);
        const std::vector<Real> there = exact(formulation, Real(1) / 4 + h / 4 * 3);
        std::vector<Real> y(y0.size());
        Interpolant interpolant(system);
        REQUIRE(interpolant.set(Real(1) / 4, h, y0.data(), y1.data()) == Status::ok);
        interpolant.at(Real(3) / 4, y.data());
        return distances(group, there, y);
    };
    const Real h = KREISEL_QUAD ? Real(1) / 256 : Real(1) / 32;
    const auto [q, v] = error(h);
    const auto [q_half, v_half] = error(h / 2);
    return {std::log2(q / q_half), std::log2(v / v_half)};
}

/// The same of a method's own dense output, in the second of two steps, whose first slope may be the last of the first.
std::pair<double, double> observed_own(const Method& entry, const OptionValues& options, System& system,
                                       const std::string& formulation) {
    const TangentGroup& group = system.state_group();
    const auto error = [&](const Real& h) {
        const auto method = entry.bind(system, with_defaults(options, entry.description.options));
        const std::vector<Real> there = exact(formulation, Real(1) / 4 + h / 4 * 3);
        std::vector<Real> y = exact(formulation, Real(1) / 4 - h), next = y, error_of_step(y.size());
        REQUIRE(method->start(0, y.data()) == Status::ok);
        for (int step = 0; step < 2; ++step) {
            const Real t = Real(1) / 4 + (step - 1) * h;
            for (const Real& size : {Real(2 * h), h})  // the first is rejected
                REQUIRE(method->attempt(t, size, y.data(), next.data(), error_of_step.data()) == Status::ok);
            method->accept(false);
            if (step == 0) y = next;
        }
        method->interpolate(Real(3) / 4, h, y.data(), next.data());
        return distances(group, there, next);
    };
    const Real h = Real(1) / (KREISEL_QUAD ? 256 : 64);
    const auto [q, v] = error(h);
    const auto [q_half, v_half] = error(h / 2);
    return {std::log2(q / q_half), std::log2(v / v_half)};
}

}  // namespace

TEST_CASE("dense output of a method's own has its order on the group", "[control]") {
    int met = 0;
    for (const Method& entry : methods()) {
        const int order = entry.description.dense;
        if (order == 0) continue;
        for (const std::string formulation : {"SO3xR3", "SE3", "SO3"})
            for (const std::string coordinates : {"exp", "cayley", "second_kind"}) {
                if (KREISEL_QUAD && coordinates != "exp") continue;  // slow
                const auto system = make_system(models::standard("forced_heavy_top"), formulation);
                const auto [q, v] = observed_own(entry, {{"coordinates", coordinates}}, *system, formulation);
                INFO(entry.description.name << ", " << formulation << ", " << coordinates << ": " << q << ", " << v);
                CHECK(std::min(q, v) > order + 1 - 0.3);
                ++met;
            }
    }
    CHECK(met >= (KREISEL_QUAD ? 6 : 18));
}

TEST_CASE("dense output has local errors O(h^6) in q and O(h^5) in v", "[control]") {
    for (const std::string formulation : {"SO3xR3", "SE3", "S3xR3", "SO3"}) {
        const auto system = make_system(models::standard("forced_heavy_top"), formulation);
        const auto [q, v] = observed(*system, formulation);
        INFO(formulation << ": " << q << ", " << v);
        CHECK(std::abs(q - 6) < 0.25);
        CHECK(std::abs(v - 5) < 0.25);
    }
}

TEST_CASE("dense output from wrong accelerations has a lower order, and is seen", "[control]") {
    const auto system = make_system(models::standard("forced_heavy_top"), "SO3xR3");
    WrongAccelerations wrong(*system);
    const auto [q, v] = observed(wrong, "SO3xR3");
    CHECK(q < 3);
    CHECK(v < 2);
}

TEST_CASE("dense output meets both ends of a step", "[control]") {
    for (const std::string formulation : {"SO3xR3", "SE3", "S3xR3", "SO3"}) {
        const auto system = make_system(models::standard("forced_heavy_top"), formulation);
        const std::vector<Real> y0 = exact(formulation, 0), y1 = exact(formulation, Real(1) / 8);
        Interpolant interpolant(*system);
        REQUIRE(interpolant.set(0, Real(1) / 8, y0.data(), y1.data()) == Status::ok);
        std::vector<Real> y(y0.size());
        for (const auto& [theta, end] : {std::pair(Real(0), &y0), std::pair(Real(1), &y1)}) {
            interpolant.at(theta, y.data());
            for (std::size_t i = 0; i < y.size(); ++i) CHECK(abs(y[i] - (*end)[i]) < 1000 * epsilon);
        }
    }
}
