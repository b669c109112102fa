// SPDX-License-Identifier: BSD-3-Clause
//
// A tableau written in the options of rkmk/tableau runs as the method of the same coefficients does, to the last bit:
// in constant steps and to a tolerance, in every chart.
#include <catch2/catch.hpp>

#include "mechanics/model/scales.hpp"
#include "methods/contract/method.hpp"
#include "tests/methods/control/controlled_trip.hpp"

using namespace stepping;

namespace {

const OptionValues bogacki_shampine = {{"a", "1/2; 0 3/4; 2/9 1/3 4/9"},
                                       {"b", "2/9 1/3 4/9 0"},
                                       {"b_hat", "7/24 0.25 1/3 1/8"},
                                       {"order", 3L},
                                       {"order_hat", 2L}};

OptionValues with(OptionValues options, const OptionValues& more) {
    options.insert(more.begin(), more.end());
    return with_defaults(options, method("rkmk/tableau").description.options);
}

std::vector<Real> end_state(const Method& entry, const OptionValues& options) {
    Trip trip(models::standard("heavy_top"), "SE3", entry, options);
    REQUIRE(trip.run(Real(1) / 16, 64) == Status::ok);
    return trip.y;
}

std::vector<Real> end_state_to_tolerance(const Method& entry, const OptionValues& options, long& accepted) {
    const Model model = models::standard("double_pendulum");
    ControlledTrip trip(model, "SO3xR3", entry, {.tolerance = Real(1) / 100000, .length = extent(model)},
                        "position_velocity",
                        [&](const Method& bound, System& system, Projection& project, const Accuracy& accuracy) {
                            return bind_stepper(bound, system, project, accuracy, options);
                        });
    REQUIRE(trip.run(Real(1) / 4) == Status::ok);
    accepted = trip.stepper->accepted();
    return trip.y;
}

}  // namespace

TEST_CASE("a written tableau runs as the built-in one, to the last bit", "[written_tableau]") {
    const Method &written = method("rkmk/tableau"), &rk4 = method("rkmk/rk4"), &bs3 = method("rkmk/bs3");
    const OptionValues none = default_options(rk4.description.options);
    CHECK(end_state(written, with({}, {})) == end_state(rk4, none));
    for (const OptionValues& chart :
         {OptionValues{{"coordinates", "cayley"}}, OptionValues{{"dexpinv", "seed"}}, OptionValues{{"dexpinv", 1L}}})
        CHECK(end_state(written, with(bogacki_shampine, chart)) ==
              end_state(bs3, with_defaults(chart, bs3.description.options)));
    CHECK(end_state(written, with(bogacki_shampine, {})) != end_state(written, with({}, {})));
}

TEST_CASE("a written pair chooses its steps as the built-in one", "[written_tableau]") {
    const Method &written = method("rkmk/tableau"), &bs3 = method("rkmk/bs3");
    long accepted = 0, expected = 0;
    CHECK(end_state_to_tolerance(written, with(bogacki_shampine, {}), accepted) ==
          end_state_to_tolerance(bs3, default_options(bs3.description.options), expected));
    CHECK(accepted == expected);
    CHECK_THROWS_AS(end_state_to_tolerance(written, with({}, {}), accepted), std::logic_error);
}

TEST_CASE("order and estimate of a written tableau are those of its options", "[written_tableau]") {
    const Method& written = method("rkmk/tableau");
    CHECK(written.under(with({}, {})).order == Order(4));
    CHECK(written.under(with({}, {})).estimate == 0);
    CHECK(written.under(with(bogacki_shampine, {})).order == Order(3));
    CHECK(written.under(with(bogacki_shampine, {})).estimate == 3);
    CHECK(written.under(with(bogacki_shampine, {{"dexpinv", 0L}})).order == Order(2));
}

TEST_CASE("a tableau without its order does not run", "[written_tableau]") {
    const Method& written = method("rkmk/tableau");
    const auto system = make_system(models::standard("heavy_top"), "SE3");
    const OptionValues wrong = with({{"order", 5L}}, {});
    CHECK_THROWS_AS(written.factory.why_not(wrong), OptionError);
    CHECK_THROWS_AS(written.bind(*system, wrong), OptionError);
    CHECK(written.factory.why_not(with({}, {})) == "");
    CHECK_THAT(written.factory.why_not(with({}, {{"coordinates", "cayley"}, {"dexpinv", 1L}})),
               Catch::Contains("cayley"));
}
