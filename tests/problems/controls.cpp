// SPDX-License-Identifier: BSD-3-Clause
//
// Systems with one fault each: every check has a case that it must reject.
#include <memory>

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
    gyroscopic_missing,  ///< no gyroscopic term
    multiplier_sign,     ///< lambda of the other convention
    acceleration_off,    ///< v' is off by 1e-6 relative
    integral_drifts,     ///< a declared first integral that is not one
};

/// A system of the library except for the fault.
class Broken final : public System {
  public:
    Broken(const Model& model, const std::string& formulation, Fault fault)
        : Broken(make_system(model, formulation), fault) {}

    int constraints() const override { return inner_->constraints(); }
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        const Status status = inner_->accelerations(t, q, v, dv, lambda);
        if (fault_ == Fault::acceleration_off) dv[velocities() - 1] *= 1 + Real(1) / 1000000;
        if (lambda && fault_ == Fault::multiplier_sign) Eigen::Map<VecX>(lambda, constraints()) *= -1;
        return status;
    }
    int mass_block() const override { return inner_->mass_block(); }
    void mass(const Real* q, Real* blocks) const override {
        inner_->mass(q, blocks);
        if (fault_ == Fault::mass_asymmetric) blocks[1] += Real(1) / 1000;
        if (fault_ == Fault::mass_indefinite) blocks[mass_block() * mass_block() - 1] *= -1;
    }
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override {
        inner_->applied_force(t, q, v, f);
        if (fault_ == Fault::force_sign) Eigen::Map<VecX>(f, velocities()) *= -1;
    }
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override {
        inner_->gyroscopic_force(q, v, f);
        if (fault_ == Fault::gyroscopic_missing) Eigen::Map<VecX>(f, velocities()).setZero();
    }
    void position_residual(const Real& t, const Real* q, Real* phi) const override {
        inner_->position_residual(t, q, phi);
    }
    void jacobian(const Real& t, const Real* q, Real* C) const override {
        inner_->jacobian(t, q, C);
        Real& entry = C[4 * constraints()];  // of the rotation columns
        if (fault_ == Fault::jacobian_sign) entry = -entry;
        if (fault_ == Fault::jacobian_small) entry *= 1 + Real(1) / 1000000;
    }
    void velocity_bias(const Real& t, const Real* q, Real* b) const override { inner_->velocity_bias(t, q, b); }
    void velocity_residual(const Real& t, const Real* q, const Real* v, Real* r) const override {
        inner_->velocity_residual(t, q, v, r);
        if (fault_ == Fault::velocity_row) r[0] += v[3] / 1000;
    }
    void acceleration_bias(const Real& t, const Real* q, const Real* v, Real* xi) const override {
        inner_->acceleration_bias(t, q, v, xi);
        if (fault_ == Fault::bias_missing) Eigen::Map<VecX>(xi, constraints()).setZero();
    }
    bool has_potential() const override { return inner_->has_potential(); }
    Real potential(const Real& t, const Real* q) const override { return inner_->potential(t, q); }
    int bodies() const override { return inner_->bodies(); }
    void read(const Real* y, BodyState* bodies) const override { inner_->read(y, bodies); }
    void write(const BodyState* bodies, Real* y) const override { inner_->write(bodies, y); }

  private:
    Broken(std::unique_ptr<System> inner, Fault fault)
        : System(std::shared_ptr<const Group>(&inner->group(), [](const Group*) {})),
          inner_(std::move(inner)),
          fault_(fault) {
        auto integrals = inner_->integrals();
        if (fault == Fault::integral_drifts)
            integrals.push_back({"height", "m", "none", [](const MotionState& s) { return s.bodies[0].x[2]; },
                                 [](const MotionState&) { return Real(1); }});
        set_integrals(std::move(integrals));
    }

    std::unique_ptr<System> inner_;
    Fault fault_;
};

using Check = std::string (*)(System&, const At&);

/// Whether `check` complains about the fault at some state of the double pendulum. (A top on a joint to ground has
/// xi = 0 on SE3, and one with its lever along an axis has zeros in C: such faults would not be faults.)
bool rejects(Check check, Fault fault, const std::string& formulation) {
    const Model model = models::standard("double_pendulum");
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
