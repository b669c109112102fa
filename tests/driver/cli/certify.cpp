// SPDX-License-Identifier: BSD-3-Clause
//
// The data sheet of a method, of the fake engine, whose errors fall like h^4.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/driver/command_line.hpp"
#include "tests/driver/other_engine.hpp"

using namespace kreisel;

namespace {

// Trials of problems that the fake engine has, for as long as it lives.
class FakeTrials {
  public:
    FakeTrials() {
        write("certified_orders", "convergence", R"("metrics": ["error.*"])");
        write("certified_conservation", "drift", R"("metrics": ["invariant.*"])");
        write("certified_structure", "drift", R"("metrics": ["invariant.*"])");
        write("certified_energy", "drift", R"("metrics": ["invariant.*"])");
        write("certified_cost", "work_precision", R"("description": "none")");
        ::setenv("KREISEL_EXPERIMENTS", (folder_ / "").c_str(), 1);
    }
    ~FakeTrials() { ::unsetenv("KREISEL_EXPERIMENTS"); }
    FakeTrials(const FakeTrials&) = delete;
    FakeTrials& operator=(const FakeTrials&) = delete;

  private:
    void write(const std::string& name, const std::string& kind, const std::string& more) {
        folder_.file(name + ".json", R"({"name": ")" + name + R"(", "kind": ")" + kind +
                                         R"(", "problems": ["free_top"], "methods": ["rkmk/rk4"],
            "time": {"end": 1.0, "steps": {"from": 16, "levels": 6}}, )" +
                                         more + "}");
    }

    ScratchFolder folder_;
};

}  // namespace

TEST_CASE("certify prints and writes the data sheet of a method") {
    const FakeTrials trials;
    const ScratchFolder scratch;
    const auto result = run_program({"certify", "rkmk/rk4", "-o", (scratch / "sheets").string()});
    INFO(result.out << result.messages);
    REQUIRE(result.code == 0);
    CHECK_THAT(result.out, Catch::StartsWith("rkmk/rk4: classical\n"));
    for (const char* part :
         {"Sources: kutta1901", "a_2", "0, 1", "Declared and observed orders", "4.00", "First integrals",
          "Cost of an accuracy", "Stability on a test rotation", "2.8284", "-1.04e-04"}) {
        CHECK_THAT(result.out, Catch::Contains(part));
    }
    CHECK(contents(scratch / "sheets" / "rkmk-rk4.txt") == result.out);
    CHECK_THAT(contents(scratch / "sheets" / "rkmk-rk4.md"), Catch::StartsWith("# rkmk/rk4: classical\n"));
    CHECK_THAT(contents(scratch / "sheets" / "rkmk-rk4.tex"), Catch::StartsWith("\\section{rkmk/rk4: classical}\n"));
}

TEST_CASE("a method that declares an order too high, or fails, is not certified") {
    class BoastingEngine final : public OtherEngine {
        std::vector<MethodDescription> methods() const override {
            return {{"rkmk/rk4", 5, {}, "classical", 4}, {"fake/nan", 1, {}, "fails"}};
        }
        MethodDescription method(const std::string& name, const OptionValues&) const override {
            return name == "rkmk/rk4" ? methods().front() : methods().back();
        }
    };
    const FakeTrials trials;
    const auto high = run_program({"certify", "rkmk/rk4"}, BoastingEngine());
    CHECK(high.code == 1);
    CHECK_THAT(high.messages, Catch::Contains("not certified: an order falls short of the declared one"));
    const auto failing = run_program({"certify", "fake/nan"}, BoastingEngine());
    CHECK(failing.code == 1);
    CHECK_THAT(failing.messages, Catch::Contains("not certified: free_top on SO3xR3: non_finite"));
}

TEST_CASE("certify names the nearest method") {
    const auto result = run_program({"certify", "rkmk/rk5"});
    CHECK(result.code == 2);
    CHECK_THAT(result.messages, Catch::Contains("did you mean \"rkmk/rk4\"?"));
}

TEST_CASE("the atlas has every method, with the orders that studies observed, and runs nothing") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("study.json", R"({"name": "study", "kind": "convergence",
        "problems": ["free_top"], "methods": ["rkmk/rk4"], "metrics": ["error.*"],
        "time": {"end": 1.0, "steps": {"from": 16, "levels": 6}}})");
    const std::string results = (scratch / "study").string(), output = (scratch / "atlas").string();
    REQUIRE(run_program({"run", config, "-o", results}).code == 0);
    const auto printed = run_program({"atlas", results});
    CHECK(printed.code == 0);
    CHECK_THAT(printed.out, Catch::Contains("rkmk/rk4: classical\nSources: kutta1901\norder 4; explicit"));
    CHECK_THAT(printed.out, Catch::Contains("free_top  4.00 / - / -"));
    REQUIRE(run_program({"atlas", results, "-o", output}).code == 0);
    const std::string latex = contents(scratch / "atlas" / "atlas.tex");
    CHECK_THAT(latex, Catch::Contains("\\atlasmethod{rkmk/rk4}{classical}{kutta1901}{Order 4; explicit"));
    CHECK_THAT(latex, Catch::Contains("\\atlascoefficients{"));
    CHECK_THAT(latex, Catch::Contains("free\\_top & 4.00"));
    CHECK_THAT(latex, Catch::Contains("\\atlasmethod{fake/nan}"));
    CHECK(run_program({"atlas", (scratch / "nowhere").string()}).code == 3);
}
