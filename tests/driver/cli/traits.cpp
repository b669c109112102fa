// SPDX-License-Identifier: BSD-3-Clause
//
// Methods selected by family and by what they declare.
#include <catch2/catch.hpp>

#include "driver/cli/catalogue/traits.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/other_engine.hpp"

using namespace kreisel;

namespace {

class EngineWithTraits final : public OtherEngine {
    std::vector<MethodDescription> methods() const override {
        return {{.name = "gauss/two", .form = Form::implicit, .preserves = {{Property::symplectic, Domain::free}}},
                {.name = "gauss/three",
                 .form = Form::implicit,
                 .preserves = {{Property::symplectic, Domain::potential}, {Property::symmetric, Domain::autonomous}}},
                {.name = "kicks/strang", .preserves = {{Property::symmetric, Domain::free}}},
                {.name = "kicks/pair", .estimate = 4},
                {.name = "half/herk", .form = Form::half_explicit}};
    }
};

// The names after "kreisel list methods" and these words.
std::vector<std::string> listed_with(std::vector<std::string> words) {
    words.insert(words.begin(), {"list", "methods"});
    const auto result = run_program(words, EngineWithTraits());
    CHECK(result.code == 0);
    std::vector<std::string> names;
    for (const MethodDescription& method : static_cast<const Engine&>(EngineWithTraits()).methods()) {
        if (result.out.find("  " + method.name + " ") != std::string::npos) { names.push_back(method.name); }
    }
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("list methods by family and traits") {
    CHECK(listed_with({}).size() == 5);
    CHECK(listed_with({"--family", "gauss"}) == Names{"gauss/two", "gauss/three"});
    CHECK(listed_with({"--symplectic"}) == Names{"gauss/two", "gauss/three"});
    CHECK(listed_with({"--symplectic", "--symmetric"}) == Names{"gauss/three"});
    CHECK(listed_with({"--family", "kicks", "--symmetric"}) == Names{"kicks/strang"});
    CHECK(listed_with({"--explicit"}) == Names{"kicks/strang", "kicks/pair"});
    CHECK(listed_with({"--half-explicit"}) == Names{"half/herk"});
    CHECK(listed_with({"--implicit", "--adaptive"}).empty());
    CHECK(listed_with({"--adaptive"}) == Names{"kicks/pair"});
    CHECK(listed_with({"--energy-preserving"}).empty());
}

TEST_CASE("every property and form is a trait") {
    for (const char* name : {"symplectic", "symmetric", "momentum-preserving", "energy-preserving",
                             "constraint-preserving", "explicit", "half-explicit", "implicit"}) {
        INFO(name);
        CHECK(run_program({"list", std::string("--") + name}).code == 0);
    }
}

TEST_CASE("a filter that is misspelt, or of another topic, is an error") {
    const auto family = run_program({"list", "methods", "--family", "rkkm"});
    CHECK(family.code == 2);
    CHECK_THAT(family.messages, Catch::Contains("--family: expected one of \"rkmk\", \"baseline\", \"fake\", got "
                                                "\"rkkm\"; did you mean \"rkmk\"?"));
    const auto trait = run_program({"list", "methods", "--symplektic"});
    CHECK(trait.code == 2);
    CHECK_THAT(trait.messages, Catch::Contains("did you mean \"--symplectic\"?"));
    const auto topic = run_program({"list", "problems", "--symplectic"});
    CHECK(topic.code == 2);
    CHECK_THAT(topic.messages, Catch::Contains("got the topic \"problems\""));
}
