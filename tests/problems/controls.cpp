// SPDX-License-Identifier: BSD-3-Clause
//
// Systems with one fault each: every check has a case that it must reject.
#include <memory>

#include "mechanics/forwarding_system.hpp"
#include "mechanics/start.hpp"
#include "tests/problems/states.hpp"

using namespace kreisel;
using namespace checks;

namespace {

enum class Fault {
    none,
    mass_asymmetric,     ///< M_01 is off
    mass_indefinite,     ///< the sign of a moment of inertia
    jacobian_sign,       ///< one entry of C has the other sign
    jacobian_small,      ///< one entry of C is off by 1e-6
    velocity_row,        ///< a velocity row is not C v + b
    bias_missing,        ///< xi without its centripetal term
    force_sign,          ///< the applied force is reversed
    damping_sign,        ///< the dissipative force is reversed
    conservative_off,    ///< the conservative force is off by 1e-6 relative
    dampers_denied,      ///< the system says that it has none
    gyroscopic_missing,  ///< no gyroscopic term
    multiplier_sign,     ///< lambda of the other convention
    acceleration_off,    ///< v' is off by 1e-6 relative
    integral_drifts,     ///< a declared first integral that is not one
};

/// A system of the library except for the fault.
class Broken final : public ForwardingSystem {
  public:
    Broken(const Model& model, const std::string& formulation, Fault fault)
        : ForwardingSystem(make_system(model, formulation)), fault_(fault) {
        if (fault == Fault::integral_drifts) declare_height_constant();
    }

    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        const Status status = ForwardingSystem::accelerations(t, q, v, dv, lambda);
        if (fault_ == Fault::acceleration_off) dv[velocities() - 1] *= 1 + Real(1) / 1000000;
        if (lambda && fault_ == Fault::multiplier_sign) Eigen::Map<VecX>(lambda, constraints()) *= -1;
        return status;
    }
    void mass(const Real* q, Real* blocks) const override {
        ForwardingSystem::mass(q, blocks);
        if (fault_ == Fault::mass_asymmetric) blocks[1] += Real(1) / 1000;
        if (fault_ == Fault::mass_indefinite) blocks[mass_block() * mass_block() - 1] *= -1;
    }
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override {
        ForwardingSystem::applied_force(t, q, v, f);
        if (fault_ == Fault::force_sign) Eigen::Map<VecX>(f, velocities()) *= -1;
    }
    void conservative_force(const Real& t, const Real* q, Real* f) const override {
        ForwardingSystem::conservative_force(t, q, f);
        if (fault_ == Fault::conservative_off) Eigen::Map<VecX>(f, velocities()) *= 1 + Real(1) / 1000000;
    }
    void dissipative_force(const Real& t, const Real* q, const Real* v, Real* f) const override {
        ForwardingSystem::dissipative_force(t, q, v, f);
        if (fault_ == Fault::damping_sign) Eigen::Map<VecX>(f, velocities()) *= -1;
    }
    bool is_dissipative() const override {
        return fault_ != Fault::dampers_denied && ForwardingSystem::is_dissipative();
    }
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override {
        ForwardingSystem::gyroscopic_force(q, v, f);
        if (fault_ == Fault::gyroscopic_missing) Eigen::Map<VecX>(f, velocities()).setZero();
    }
    void jacobian(const Real& t, const Real* q, Real* C) const override {
        ForwardingSystem::jacobian(t, q, C);
        Real& entry = C[4 * constraints()];  // of the rotation columns
        if (fault_ == Fault::jacobian_sign) entry = -entry;
        if (fault_ == Fault::jacobian_small) entry *= 1 + Real(1) / 1000000;
    }
    void velocity_residual(const Real& t, const Real* q, const Real* v, Real* r) const override {
        ForwardingSystem::velocity_residual(t, q, v, r);
        if (fault_ == Fault::velocity_row) r[0] += v[3] / 1000;
    }
    void acceleration_bias(const Real& t, const Real* q, const Real* v, Real* xi) const override {
        ForwardingSystem::acceleration_bias(t, q, v, xi);
        if (fault_ == Fault::bias_missing) Eigen::Map<VecX>(xi, constraints()).setZero();
    }

  private:
    void declare_height_constant() {
        auto all = integrals();
        all.push_back({"height", "m", "none", [](const MotionState& s) { return s.bodies[0].x[2]; },
                       [](const MotionState&) { return Real(1); }});
        set_integrals(std::move(all));
    }

    Fault fault_;
};

using Check = std::string (*)(System&, const At&);

/// Whether `check` complains about the fault at some state of a model, the double pendulum as a rule. (A top on a joint
/// to ground has xi = 0 on SE3, and one with its lever along an axis has zeros in C: such faults would not be faults.)
bool rejects(Check check, Fault fault, const std::string& formulation,
             const Model& model = models::standard("double_pendulum")) {
    Broken system(model, formulation, fault);
    for (const states::Pose& pose : states::poses(model, 4))
        if (!check(system, states::in_coordinates(system, pose)).empty()) return true;
    return false;
}

struct Control {
    const char* name;
    Check check;
    std::vector<Fault> faults;
};

const Control controls[] = {
    {"mass", mass_is_positive, {Fault::mass_asymmetric, Fault::mass_indefinite}},
    {"jacobian", jacobian_is_derivative, {Fault::jacobian_sign, Fault::jacobian_small}},
    {"velocity rows", velocity_rows_are_consistent, {Fault::velocity_row, Fault::jacobian_sign}},
    {"bias", bias_is_derivative, {Fault::bias_missing, Fault::jacobian_sign, Fault::velocity_row}},
    {"index-1 system",
     accelerations_solve_kkt,
     {Fault::force_sign, Fault::gyroscopic_missing, Fault::multiplier_sign, Fault::acceleration_off,
      Fault::bias_missing}},
    {"potential", force_is_gradient, {Fault::force_sign}},
    {"integrals", integrals_are_constant, {Fault::integral_drifts, Fault::acceleration_off}},
};

}  // namespace

TEST_CASE("every check rejects a system with a fault, and only that", "[problems][control]") {
    for (const Control& control : controls)
        for (const char* formulation : {"SO3xR3", "SE3"}) {
            INFO(control.name << " on " << formulation);
            CHECK_FALSE(rejects(control.check, Fault::none, formulation));
            for (const Fault fault : control.faults) {
                INFO("fault " << static_cast<int>(fault));
                CHECK(rejects(control.check, fault, formulation));
            }
        }
}

TEST_CASE("a wrong part of a force is rejected", "[problems][control]") {
    const Model model = models::damped("revolute");
    for (const char* formulation : {"SO3xR3", "SE3"}) {
        INFO(formulation);
        CHECK_FALSE(rejects(force_parts_add_up, Fault::none, formulation, model));
        for (const Fault fault :
             {Fault::force_sign, Fault::damping_sign, Fault::conservative_off, Fault::dampers_denied}) {
            INFO("fault " << static_cast<int>(fault));
            CHECK(rejects(force_parts_add_up, fault, formulation, model));
        }
    }
}

TEST_CASE("formulations that differ are rejected", "[problems][control]") {
    const Model model = models::standard("heavy_top");
    const states::Pose pose = states::poses(model, 1)[1];
    const auto good = make_system(model, "SE3");
    const Dynamics reference = dynamics(*good, states::in_coordinates(*good, pose));
    for (const Fault fault : {Fault::multiplier_sign, Fault::acceleration_off}) {
        Broken bad(model, "SO3xR3", fault);
        CHECK_FALSE(same_dynamics(reference, dynamics(bad, states::in_coordinates(bad, pose))).empty());
    }
    Dynamics nothing = reference;
    nothing.accelerations[0] = std::numeric_limits<Real>::quiet_NaN();
    CHECK_FALSE(same_dynamics(reference, nothing).empty());
}

TEST_CASE("a start off the joints is rejected", "[problems][control]") {
    Model model = models::standard("double_pendulum");
    model.bodies[1].start.x[0] += Real(1) / 1000000;
    CHECK_THROWS_AS(check_start(model), ParameterError);
    model = models::standard("double_pendulum");
    model.bodies[1].start.v[0] += Real(1) / 1000000;
    CHECK_THROWS_AS(check_start(model), ParameterError);
}
