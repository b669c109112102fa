// SPDX-License-Identifier: BSD-3-Clause
//
// Rotations, quaternions and inertias as programs print them: what is repaired, by how much, and what is refused.
#include <catch2/catch.hpp>
#include <cmath>

#include "driver/config/config.hpp"
#include "records/json/diagnostics.hpp"
#include "records/json/strict.hpp"
#include "support/errors.hpp"
#include "tests/driver/fake_engine.hpp"

using namespace kreisel;

namespace {

using Catch::Contains;

// A body with these keys, as a config reads it.
Config read_body_with(const std::string& keys, const std::string& beside = "") {
    const std::string text = R"({"name": "n", "kind": "drift", "methods": ["rkmk/rk4"], "time": {"end": 1, "steps": 4},
        "problems": [{"name": "multibody")" +
                             beside + R"(, "parameters": {"bodies": [{"name": "a", "mass": 1, "x": [0, 0, 0], )" +
                             keys + "}]}}]}";
    const FakeEngine engine;
    return read_config(parse_document("n.json", text), Catalogue(engine));
}

BodyData body_of(const Config& config) {
    return std::get<std::vector<BodyData>>(config.problems.at(0).parameters().at("bodies")).at(0);
}

std::string refusal_of_body(const std::string& keys, const std::string& beside = "") {
    try {
        read_body_with(keys, beside);
    } catch (const UsageError& error) { return error.what(); }
    return "";
}

double orthogonality_defect(const Matrix3& R) {
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            double sum = i == j ? -1 : 0;
            for (std::size_t k = 0; k < 3; ++k) { sum += R[3 * k + i] * R[3 * k + j]; }
            worst = std::max(worst, std::abs(sum));
        }
    }
    return worst;
}

// J_1 + J_2 - J_3 of a diagonal inertia.
double slack(const Matrix3& J) { return J[0] + J[4] - J[8]; }

const std::string ball = R"("inertia": [1, 1, 1])";

}  // namespace

TEST_CASE("a rotation of six to eight digits becomes the nearest one, with a warning") {
    for (const char* R : {"[[0.866025, -0.5, 0], [0.5, 0.866025, 0], [0, 0, 1]]",
                          "[[0.35355339, -0.61237244, 0.70710678], [0.92677669, 0.12682648, -0.35355339], "
                          "[0.12682648, 0.78033009, 0.61237244]]"}) {
        const Config config = read_body_with(ball + R"(, "R": )" + R);
        CHECK(orthogonality_defect(body_of(config).R) < 1e-15);
        REQUIRE(config.warnings.size() == 1);
        CHECK_THAT(config.warnings[0], Contains("/problems/0/parameters/bodies/0/R: not orthogonal as printed: the "
                                                "nearest rotation is taken, which changes entries by up to"));
    }
    const Config written = read_body_with(ball + R"(, "R": [[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])");
    CHECK(written.warnings.empty());
    CHECK(body_of(written).R == Matrix3{0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1});
}

TEST_CASE("a rotation that is further off than its decimals allow is left to the engine") {
    for (const char* wrong : {"[[0.866, -0.5, 0], [0.5, 0.866, 0], [0, 0, 1]]",            // 2.5e-5 at three decimals
                              "[[0.8660354, -0.5, 0], [0.5, 0.8660354, 0], [0, 0, 1]]",    // 1e-5 at seven
                              "[[-0.866025, -0.5, 0], [0.5, 0.866025, 0], [0, 0, 1]]"}) {  // no rotation
        const Config config = read_body_with(ball + R"(, "R": )" + wrong);
        CHECK(config.warnings.empty());
        CHECK(orthogonality_defect(body_of(config).R) > 1e-6);
    }
}

TEST_CASE("a quaternion of few digits is normalised, with a warning") {
    const Config config = read_body_with(ball + R"(, "quaternion": [0.7071068, 0, 0.7071068, 0])");
    CHECK(orthogonality_defect(body_of(config).R) < 1e-15);
    REQUIRE(config.warnings.size() == 1);
    CHECK_THAT(config.warnings[0], Contains("/quaternion: of norm 1.0000000266") && Contains("up to 1.9e-08"));
    CHECK_THAT(refusal_of_body(ball + R"(, "quaternion": [0.7072, 0, 0.7071068, 0])"),
               Contains("/quaternion: expected a unit quaternion") && Contains("norm 1.0000"));
    CHECK_THAT(refusal_of_body(ball + R"(, "quaternion": [0.7071068, 0, 0.7071068, 0])", R"(, "exact": true)"),
               Contains("norm 1.0000000266"));
}

TEST_CASE("an inertia that differs from its transpose by round-off of doubles becomes symmetric") {
    // All digits of R J R^T, where the entries beside the diagonal are zero but for round-off.
    const Config config = read_body_with(R"("inertia": [[0.49, 9.1e-18, 0], [-9.1e-18, 0.49, 1.1e-17], [0, 0, 0.2]])");
    CHECK(config.warnings.size() == 1);
    CHECK_THAT(refusal_of_body(R"("inertia": [[0.49, 9.1e-15, 0], [-9.1e-15, 0.49, 0], [0, 0, 0.2]])"),
               Contains("not symmetric"));
}

TEST_CASE("an inertia whose entries differ by round-off becomes symmetric, with a warning") {
    const Config config = read_body_with(R"("inertia": [[2.5, 0.1234567, 0], [0.1234569, 2.5, 0], [0, 0, 2.5]])");
    const Matrix3 J = body_of(config).inertia;
    CHECK(J[1] == J[3]);
    CHECK(J[1] == Approx(0.1234568).epsilon(1e-12));
    REQUIRE(config.warnings.size() == 1);
    CHECK_THAT(config.warnings[0], Contains("/inertia: not symmetric as printed: the symmetric part is taken, which "
                                            "changes entries by up to 1e-07"));
    const std::string apart = R"("inertia": [[2.5, 0.1234567, 0], [0.1234577, 2.5, 0], [0, 0, 2.5]])";
    CHECK_THAT(refusal_of_body(apart),
               Contains("not symmetric: an entry is 5e-07 off its symmetric part, 2e-07 are round-off"));
    CHECK_THAT(
        refusal_of_body(R"("inertia": [[2.5, 0.1234567, 0], [0.1234569, 2.5, 0], [0, 0, 2.5]])", R"(, "exact": true)"),
        Contains("not symmetric"));
}

TEST_CASE("an inertia of a flat body that its decimals make impossible becomes the nearest possible one") {
    const Config config = read_body_with(R"("inertia": [0.3333333, 0.6666666, 1.0000001])");
    CHECK(std::abs(slack(body_of(config).inertia)) < 1e-15);
    REQUIRE(config.warnings.size() == 1);
    CHECK_THAT(config.warnings[0], Contains("/inertia: an inertia that no body has as printed"));
    const Config wrong = read_body_with(R"("inertia": [0.3, 0.6, 1.5])");
    CHECK(wrong.warnings.empty());
    CHECK(slack(body_of(wrong).inertia) < -0.5);  // for the engine to refuse
    const Config right = read_body_with(R"("inertia": [1, 2, 3])");
    CHECK(right.warnings.empty());
    CHECK(body_of(right).inertia == Matrix3{1, 0, 0, 0, 2, 0, 0, 0, 3});
}

TEST_CASE("numbers of any size are left alone where they are right") {
    for (const char* J : {"[1e-99, 1e-99, 1e-99]", "[1e99, 1e99, 1e99]"}) {
        CHECK(read_body_with(std::string(R"("inertia": )") + J).warnings.empty());
    }
}
