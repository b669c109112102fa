// SPDX-License-Identifier: BSD-3-Clause
#include "records/rows/named_numbers.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

using namespace kreisel;

namespace named_numbers {

namespace {

std::string text_of(const NamedNumbers& numbers) {
    std::string text;
    for (const auto& [name, value] : numbers) { text += name + "=" + std::to_string(static_cast<int>(value)) + " "; }
    return text;
}

}  // namespace

TEST_CASE("numbers are found by name, and come in the order of their names") {
    NamedNumbers numbers = {{"c", 3}, {"a", 1}};
    numbers["b"] = 2;
    numbers["c"] += 4;
    CHECK(text_of(numbers) == "a=1 b=2 c=7 ");
    CHECK(numbers == NamedNumbers{{"a", 1}, {"b", 2}, {"c", 7}});
    CHECK_FALSE(numbers == NamedNumbers{{"a", 1}, {"b", 2}, {"d", 7}});
    CHECK(numbers.find("b")->second == 2);
    for (const char* absent : {"", "aa", "d"}) { CHECK_FALSE(numbers.contains(absent)); }
    CHECK_THROWS_AS(numbers.at("aa"), std::out_of_range);
    numbers.erase("a");
    numbers.erase("aa");
    CHECK(text_of(numbers) == "b=2 c=7 ");
    numbers.clear();
    CHECK(numbers.empty());
}

TEST_CASE("numbers that share their names change alone") {
    Pool<NamedNumbers::Names> pool;
    NamedNumbers first = {{"a", 1}, {"b", 2}}, second = {{"a", 3}, {"b", 4}};
    first.share_names(pool);
    second.share_names(pool);
    CHECK(&first.begin()->first == &second.begin()->first);
    second["c"] = 5;
    second.erase("a");
    CHECK(text_of(first) == "a=1 b=2 ");
    CHECK(text_of(second) == "b=4 c=5 ");
}

TEST_CASE("equal values are kept once, others apart") {
    Pool<std::string> pool;
    Shared<std::string> first = std::string("x"), second = std::string("x"), other = std::string("y");
    CHECK(&*first != &*second);
    for (Shared<std::string>* value : {&first, &second, &other}) { pool.share(*value); }
    CHECK(&*first == &*second);
    CHECK(*other == "y");
    CHECK(Shared<std::string>()->empty());
}

}  // namespace named_numbers
