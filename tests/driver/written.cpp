// SPDX-License-Identifier: BSD-3-Clause
//
// JSON of ours that is passed on as it is written.
#include "records/json/written/written.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "records/cell/codec.hpp"
#include "records/cell/state_entries.hpp"
#include "records/cell/states/state_names.hpp"
#include "records/cell/states/written_state.hpp"
#include "records/json/exact.hpp"

using namespace kreisel;

namespace passed_on {

namespace {

using Entries = std::vector<std::vector<std::string>>;

// Names, families, units and digits of the numbers of a state, which is read.
Entries entries_read(const std::string& json) {
    ReportedState state;
    decode(parse_exactly(json), state);
    Entries entries;
    for (const StateEntry& entry : state_entries(state)) {
        entries.push_back({entry.name, entry.family, entry.unit, entry.number.text});
    }
    return entries;
}

// The same of one that is not.
Entries entries_written(const std::string& json) {
    const WrittenState state = written_state(json);
    Entries entries;
    name_state(state, state.turns, [&](const StateEntryName& entry, std::string_view number) {
        entries.push_back(
            {std::string(entry.name), std::string(entry.family), std::string(entry.unit), std::string(number)});
    });
    return entries;
}

// What stands in a value, with its place in "m".
Entries places_in(std::string_view json) {
    Entries entries;
    std::string path = "m";
    for_each_scalar(json, path, [&](std::string_view scalar) { entries.push_back({path, std::string(scalar)}); });
    CHECK(path == "m");
    return entries;
}

const std::string body = R"({"name":"rod \"1\"","x":[-0,1e-05,3],"R":[[1,0,0],[0,1,0],[0,0,1]],"v":[1,2,3],)"
                         R"("omega":[4,5,6]})";
const std::string quad = R"({"t":"1","bodies":[{"name":"a","x":["-0","1e-05","3"],)"
                         R"("R":[["1","0","0"],["0","1","0"],["0","0","1"]],"v":["1","2","3"],)"
                         R"("omega":["4","5","6"]},{"name":"12","x":["1","2","3"]}],"multipliers":["7","9"],)"
                         R"("multiplier_names":["lambda.pin.1 [N]","lambda.a \"b\".2"],)"
                         R"("reactions":[{"joint":"pin","force":["1","2","3"],"torque":["4","5","6"],)"
                         R"("driving_force":"7","driving_torque":"8","unique":false},{"joint":"b"}],)"
                         R"("theta":["8"],"turns":[-2]})";

}  // namespace

TEST_CASE("JSON is taken apart where it is passed on, and refused where it does not fit together") {
    const std::string object = R"({"a":1,"b \"c\"":"x,}\\","d":{"e":[1,{}]},"f":[]})";
    const auto members = members_of(object);
    REQUIRE(members.size() == 4);
    CHECK(text_of(members[1].json) == "x,}\\");
    WrittenObject written(object);
    CHECK(written.value_of("f") == "[]");
    CHECK(written.value_of("d") == R"({"e":[1,{}]})");
    CHECK(written.value_of("e").empty());
    CHECK(elements_of(WrittenObject(written.value_of("d")).value_of("e")) == std::vector<std::string_view>{"1", "{}"});
    const auto names_behind = [&](std::string_view begin, std::string_view text) {
        std::vector<std::string_view> names;
        for (const WrittenMember& member : members_behind(begin, text)) { names.push_back(member.name); }
        return names;
    };
    using Names = std::vector<std::string_view>;
    CHECK(names_behind(R"({"a":1,"b \"c\"":"x,}\\")", object) == Names{"d", "f"});
    CHECK(names_behind(object.substr(0, object.size() - 1), object).empty());
    CHECK(names_behind(R"({"a":1)", R"({"a":15,"b":2})") == Names{"a", "b"});
    CHECK(names_behind(R"({"a":2)", R"({"a":1,"b":2})") == Names{"a", "b"});
    CHECK_THROWS_AS(names_behind(R"({"a":1)", R"({"a":1,"b":2)"), std::invalid_argument);
    CHECK(elements_of("[]").empty());
    CHECK(scalars_of("[]").empty());
    CHECK(scalars_of(R"([[1,"a]"],[],2,{"b":[3]}])") ==
          std::vector<std::string_view>{"1", R"("a]")", "2", R"({"b":[3]})"});
    CHECK(members_of("{}").empty());
    CHECK(places_in("7") == Entries{{"m", "7"}});
    CHECK(places_in(R"([[1,"a]"],[],{"b":[3]},[[4]]])") ==
          Entries{{"m.1.1", "1"}, {"m.1.2", R"("a]")"}, {"m.3", R"({"b":[3]})"}, {"m.4.1.1", "4"}});
    CHECK(text_of("-0.5") == "-0.5");
    CHECK(text_of("\"\"").empty());
    CHECK(text_of("null").empty());
    std::string unescaped;
    CHECK(text_of(R"("\u00e9\n")", unescaped) == "\u00e9\n");
    CHECK(text_of(R"("plain")", unescaped) == "plain");
    for (std::size_t i = 0; i < object.size(); ++i) {
        CHECK_THROWS_AS(members_of(object.substr(0, i)), std::invalid_argument);
    }
    for (const char* text :
         {"[1]", R"({"a"1})", R"({"a":})", R"({"a":1,})", R"({a:1})", R"({"a":1}})", R"({"a":[}]})"}) {
        INFO(text);
        CHECK_THROWS_AS(members_of(text), std::invalid_argument);
    }
    for (const char* text : {"1", "[1", "[[1]", "[1]]", "[[1}]", "[1,]"}) {
        INFO(text);
        CHECK_THROWS_AS(scalars_of(text), std::invalid_argument);
        if (text[0] == '[') { CHECK_THROWS_AS(places_in(text), std::invalid_argument); }
    }
}

TEST_CASE("a state that is passed on has the names and digits of one that is read") {
    for (const std::string& json :
         {R"({"t":0.25,"bodies":[)" + body + "]}", R"({"bodies":[)" + body + R"(,{}],"multipliers":[1,2]})", quad,
          std::string("{}")}) {
        INFO(json);
        CHECK(entries_written(json) == entries_read(json));
    }
    CHECK(entries_written(quad).size() == 55);
}

TEST_CASE("a state that is none is not passed on") {
    for (const char* json :
         {"null", "[]", R"({"t":1)", R"({"bodies":[{"x":[1,2]}]})", R"({"bodies":[{"R":[[1,2,3]]}]})",
          R"({"bodies":{}})", R"({"reactions":[{"joint":"a","force":7}]})"}) {
        INFO(json);
        CHECK_THROWS_AS(written_state(json), std::invalid_argument);
    }
}

}  // namespace passed_on
