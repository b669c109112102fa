// SPDX-License-Identifier: BSD-3-Clause
//
// The Newton iteration by itself: where it converges, and how it fails.
#include "methods/implicit/newton/newton.hpp"

#include <catch2/catch.hpp>

#include "tests/methods/poisoned.hpp"

using namespace kreisel;

namespace {

/// r(x) = x^2 - c in each unknown, counted.
class Squares final : public Equations {
  public:
    explicit Squares(VecX c) : c_(std::move(c)) {}
    Status residual(const Real* x, Real* r) override {
        ++calls;
        for (Eigen::Index i = 0; i < c_.size(); ++i) r[i] = x[i] * x[i] - c_[i];
        return answer;
    }
    Real size() const override { return 1; }
    Status answer = Status::ok;
    int calls = 0;

  private:
    VecX c_;
};

/// r(x) = (-x_2, x_1): steps are orthogonal to what they change, after which Broyden's second method knows one
/// direction only, and makes nothing of a residual across it.
class QuarterTurn final : public Equations {
  public:
    Status residual(const Real* x, Real* r) override {
        r[0] = -x[1], r[1] = x[0];
        return Status::ok;
    }
    Real size() const override { return 1; }
};

/// Squares with round-off of terms that are far larger than their sum: another one at each place.
class NoisySquares final : public Equations {
  public:
    NoisySquares(VecX c, Real noise) : c_(std::move(c)), noise_(std::move(noise)) {}
    Status residual(const Real* x, Real* r) override {
        for (Eigen::Index i = 0; i < c_.size(); ++i) r[i] = x[i] * x[i] - c_[i] + noise_ * sin(13 * x[i] / epsilon);
        return Status::ok;
    }
    Real size() const override { return 1; }

  private:
    VecX c_;
    Real noise_;
};

}  // namespace

TEST_CASE("Newton's iteration ends at the round-off of residuals, however large it is", "[methods]") {
    for (const int units : {1000, 100000, 10000000}) {
        CAPTURE(units);
        const Real noise = units * epsilon;
        NoisySquares equations(VecX::Constant(3, 2), noise);
        Newton newton(3);
        Real x[3] = {Real(3) / 2, Real(5) / 4, 1};
        REQUIRE(newton.solve(equations, VecX::Ones(3), x) == Status::ok);
        for (const Real& root : x) CHECK(abs(root - sqrt(Real(2))) <= 8 * noise);
        NoisySquares rootless(VecX::Constant(3, -1), noise);
        newton.forget();
        CHECK(newton.solve(rootless, VecX::Ones(3), x) == Status::newton_failed);
    }
}

TEST_CASE("Newton's iteration ends at round-off, and keeps what it knows of the Jacobian", "[methods]") {
    Squares equations(VecX::Constant(2, 2));
    Newton newton(2);
    const VecX weights = VecX::Ones(2);
    Real x[2] = {Real(3) / 2, Real(5) / 4};
    REQUIRE(newton.solve(equations, weights, x) == Status::ok);
    for (const Real& root : x) CHECK(abs(root - sqrt(Real(2))) <= 2 * epsilon);
    equations.calls = 0;
    REQUIRE(newton.solve(equations, weights, x) == Status::ok);
    CHECK(equations.calls <= 2);
}

TEST_CASE("Newton's iteration does not end where its inverse Jacobian hides the residual", "[methods]") {
    QuarterTurn equations;
    Newton newton(2);
    Real x[2] = {sqrt(epsilon) / 16, 0};
    REQUIRE(newton.solve(equations, VecX::Ones(2), x) == Status::ok);
    for (const Real& unknown : x) CHECK(abs(unknown) <= 8 * epsilon);
}

TEST_CASE("Newton's iteration says why it fails", "[methods]") {
    Newton newton(1);
    const VecX weights = VecX::Ones(1);
    const auto solve = [&](const Real& c, const Real& guess, Status answer = Status::ok) {
        Squares equations(VecX::Constant(1, c));
        equations.answer = answer;
        Real x = guess;
        newton.forget();
        return newton.solve(equations, weights, &x);
    };
    CHECK(solve(4, 1) == Status::ok);
    CHECK(solve(-1, Real(1) / 3) == Status::newton_failed);  // no real root
    CHECK(solve(not_a_number, 1) == Status::non_finite);
    CHECK(solve(4, not_a_number) == Status::non_finite);
    CHECK(solve(4, infinite) == Status::non_finite);
    CHECK(solve(4, 1, Status::singular_kkt) == Status::singular_kkt);
}
