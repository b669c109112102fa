// SPDX-License-Identifier: BSD-3-Clause
//
// ForwardingSystem, the base of stabilisations and test doubles, forwards every virtual function of System: those that
// its header declares are called one by one, on a system that writes down what it hears.
#include <catch2/catch.hpp>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <sstream>

#include "kreisel_build.hpp"
#include "mechanics/forwarding_system.hpp"

namespace forwarding {

using namespace kreisel;

namespace {

using Heard = std::vector<std::string>;

class Listener final : public System, public SpaceAxes, public PivotRecord, public ActedUpon {
  public:
    Listener() : System(std::make_shared<AdditiveGroup>(1)) {}
    mutable Heard heard;

    int constraints() const override { return hear("constraints", 0); }
    int position_constraints() const override { return hear("position_constraints", 0); }
    Status accelerations(const Real&, const Real*, const Real*, Real*, Real*) override {
        return hear("accelerations", Status::ok);
    }
    Status solve_kkt(const Real&, const Real*, const Real*, const Real*, Real*, Real*) override {
        return hear("solve_kkt", Status::ok);
    }
    Status prepare_kkt(const Real&, const Real*) override { return hear("prepare_kkt", Status::ok); }
    Status solve_prepared(const Real&, const Real*, const Real*, const Real*, Real*, Real*) override {
        return hear("solve_prepared", Status::ok);
    }
    Status minimise_multipliers(const Real&, const Real*, Real*) override {
        return hear("minimise_multipliers", Status::ok);
    }
    Real kkt_round_off() const override { return hear("kkt_round_off", Real(0)); }
    Real least_pivot() override { return hear("least_pivot", Real(0)); }
    const StateAction* action() const override { return hear("action", static_cast<const StateAction*>(nullptr)); }
    int mass_block() const override { return hear("mass_block", 1); }
    bool mass_is_constant() const override { return hear("mass_is_constant", true); }
    void mass(const Real*, Real*) const override { hear("mass"); }
    void solve_mass(const Real*, const Real*, Real*) const override { hear("solve_mass"); }
    void applied_force(const Real&, const Real*, const Real*, Real*) const override { hear("applied_force"); }
    void gyroscopic_force(const Real*, const Real*, Real*) const override { hear("gyroscopic_force"); }
    void conservative_force(const Real&, const Real*, Real*) const override { hear("conservative_force"); }
    void dissipative_force(const Real&, const Real*, const Real*, Real*) const override { hear("dissipative_force"); }
    bool is_dissipative() const override { return hear("is_dissipative", true); }
    void position_residual(const Real&, const Real*, Real*) const override { hear("position_residual"); }
    void jacobian(const Real&, const Real*, Real*) const override { hear("jacobian"); }
    void apply_jacobian(const Real&, const Real*, const Real*, Real*) const override { hear("apply_jacobian"); }
    void apply_jacobian_transpose(const Real&, const Real*, const Real*, Real*) const override {
        hear("apply_jacobian_transpose");
    }
    void velocity_bias(const Real&, const Real*, Real*) const override { hear("velocity_bias"); }
    void velocity_residual(const Real&, const Real*, const Real*, Real*) const override { hear("velocity_residual"); }
    void acceleration_bias(const Real&, const Real*, const Real*, Real*) const override { hear("acceleration_bias"); }
    void row_scale(Real*) const override { hear("row_scale"); }
    void position_scale(const Real*, Real*) const override { hear("position_scale"); }
    ConstraintRank constraint_rank() const override { return hear("constraint_rank", ConstraintRank()); }
    std::vector<ConstraintRow> constraint_rows() const override {
        return hear("constraint_rows", std::vector<ConstraintRow>());
    }
    bool is_unique(int) const override { return hear("is_unique", true); }
    Status reactions(const Real&, const Real*, const Real*, const Real*, JointReaction*) override {
        return hear("reactions", Status::ok);
    }
    std::string reason(Status) const override { return hear("reason", std::string()); }
    Status begin_step(const Real&, const Real&, const Real*) override { return hear("begin_step", Status::ok); }
    Status end_step(Status, const Real&, Real*) override { return hear("end_step", Status::ok); }
    void read_angles(const Real*, SpringAngle*) const override { hear("read_angles"); }
    bool has_ambient_jacobian() const override { return hear("has_ambient_jacobian", true); }
    void ambient_jacobian(const Real&, const Real*, const Real*, Real*) const override { hear("ambient_jacobian"); }
    bool has_potential() const override { return hear("has_potential", true); }
    Real potential(const Real&, const Real*) const override { return hear("potential", Real(0)); }
    int bodies() const override { return hear("bodies", 0); }
    void read(const Real*, BodyState*) const override { hear("read"); }
    void write(const BodyState*, Real*) const override { hear("write"); }
    void complement_diagonal(const Real&, const Real*, Real*) const override { hear("complement_diagonal"); }
    void to_space_axes(const Real*, const Real*, Real*) const override { hear("to_space_axes"); }
    void from_space_axes(const Real*, const Real*, Real*) const override { hear("from_space_axes"); }

  private:
    void hear(const char* what) const { heard.emplace_back(what); }
    template <class T>
    T hear(const char* what, const T& answer) const {
        hear(what);
        return answer;
    }
};

struct Call {
    const char* name;
    std::function<void(ForwardingSystem&)> make;
};

const Real t = 0;
Real x[1] = {0};
BodyState body[1];
JointReaction reaction[1];
SpringAngle spring[1];

#define KREISEL_CALL(name, ...)                                  \
    Call {                                                       \
#name, [](ForwardingSystem & s) { s.name(__VA_ARGS__); } \
    }

const std::vector<Call>& calls() {
    static const std::vector<Call> all = {
        KREISEL_CALL(constraints),
        KREISEL_CALL(position_constraints),
        KREISEL_CALL(accelerations, t, x, x, x, x),
        KREISEL_CALL(solve_kkt, t, x, x, x, x, x),
        KREISEL_CALL(prepare_kkt, t, x),
        KREISEL_CALL(solve_prepared, t, x, x, x, x, x),
        KREISEL_CALL(minimise_multipliers, t, x, x),
        KREISEL_CALL(kkt_round_off),
        KREISEL_CALL(action),
        KREISEL_CALL(mass_block),
        KREISEL_CALL(mass_is_constant),
        KREISEL_CALL(mass, x, x),
        KREISEL_CALL(solve_mass, x, x, x),
        KREISEL_CALL(applied_force, t, x, x, x),
        KREISEL_CALL(gyroscopic_force, x, x, x),
        KREISEL_CALL(conservative_force, t, x, x),
        KREISEL_CALL(dissipative_force, t, x, x, x),
        KREISEL_CALL(is_dissipative),
        KREISEL_CALL(position_residual, t, x, x),
        KREISEL_CALL(jacobian, t, x, x),
        KREISEL_CALL(apply_jacobian, t, x, x, x),
        KREISEL_CALL(apply_jacobian_transpose, t, x, x, x),
        KREISEL_CALL(velocity_bias, t, x, x),
        KREISEL_CALL(velocity_residual, t, x, x, x),
        KREISEL_CALL(acceleration_bias, t, x, x, x),
        KREISEL_CALL(row_scale, x),
        KREISEL_CALL(position_scale, x, x),
        KREISEL_CALL(constraint_rank),
        KREISEL_CALL(constraint_rows),
        KREISEL_CALL(is_unique, 0),
        KREISEL_CALL(reactions, t, x, x, x, reaction),
        KREISEL_CALL(reason, Status::ok),
        KREISEL_CALL(begin_step, t, t, x),
        KREISEL_CALL(end_step, Status::ok, t, x),
        KREISEL_CALL(read_angles, x, spring),
        KREISEL_CALL(has_ambient_jacobian),
        KREISEL_CALL(ambient_jacobian, t, x, x, x),
        KREISEL_CALL(has_potential),
        KREISEL_CALL(potential, t, x),
        KREISEL_CALL(bodies),
        KREISEL_CALL(read, x, body),
        KREISEL_CALL(write, body, x),
        KREISEL_CALL(complement_diagonal, t, x, x),
        KREISEL_CALL(least_pivot),
        KREISEL_CALL(to_space_axes, x, x, x),
        KREISEL_CALL(from_space_axes, x, x, x),
    };
    return all;
}

/// The names of the virtual functions that headers declare.
std::set<std::string> declared_in(const std::vector<std::string>& headers) {
    static const std::regex virtual_function(R"(\bvirtual [^~;{(]*?(\w+)\()");
    std::set<std::string> names;
    for (const std::string& header : headers) {
        std::ifstream in(std::string(build::source_dir) + "/" + header);
        std::ostringstream out;
        out << in.rdbuf();
        const std::string text = out.str();
        for (std::sregex_iterator it(text.begin(), text.end(), virtual_function), end; it != end; ++it)
            names.insert((*it)[1]);
    }
    return names;
}

}  // namespace

TEST_CASE("a forwarding system forwards every call, once and to the same function", "[doubles]") {
    for (const Call& call : calls()) {
        Listener listener;
        ForwardingSystem system(listener);
        listener.heard.clear();  // what binding asks
        call.make(system);
        INFO(call.name);
        CHECK(listener.heard == Heard{call.name});
    }
}

TEST_CASE("those are all that systems have", "[doubles]") {
    std::set<std::string> called;
    for (const Call& call : calls()) called.insert(call.name);
    const auto declared = declared_in({"mechanics/system.hpp", "mechanics/space_axes.hpp",
                                       "mechanics/solve/pivot_record.hpp", "mechanics/actions/acted_upon.hpp"});
    CHECK(declared.size() > 40);
    CHECK(called == declared);
}

}  // namespace forwarding
