// SPDX-License-Identifier: BSD-3-Clause
#include "support/nearest.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace kreisel;

namespace {

const std::vector<std::string> names = {"rkmk/euler",
                                        "rkmk/midpoint",
                                        "rkmk/heun",
                                        "rkmk/kutta3",
                                        "rkmk/rk4",
                                        "crouch_grossman/cg2",
                                        "crouch_grossman/cg4a",
                                        "heavy_top",
                                        "free_top",
                                        "problems",
                                        "formulations",
                                        "projections",
                                        "double_pendulum",
                                        "forced_heavy_top",
                                        "convergence",
                                        "drift",
                                        "trajectory",
                                        "position_velocity",
                                        "error.multipliers",
                                        "baseline/rk4_quaternion"};

std::string random_word(std::mt19937& random, std::size_t length) {
    std::string word;
    for (std::size_t i = 0; i < length; ++i) { word += static_cast<char>('a' + random() % 26); }
    return word;
}

// One slip of the finger inside the word.
std::string mistyped(std::string word, std::mt19937& random) {
    const std::size_t at = 1 + random() % (word.size() - 2);
    switch (random() % 4) {
        case 0:
            std::swap(word[at], word[at + 1]);
            break;
        case 1:
            word.erase(at, 1);
            break;
        case 2:
            word.insert(at, 1, static_cast<char>('a' + random() % 26));
            break;
        default:
            word[at] = static_cast<char>('a' + random() % 26);
            break;
    }
    return word;
}

}  // namespace

TEST_CASE("edit distances") {
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("abc", "") == 3);
    CHECK(edit_distance("kitten", "sitting") == 3);
    CHECK(edit_distance("drift", "dirft") == 1);
    CHECK(edit_distance("ca", "abc") == 3);  // optimal string alignment; unrestricted Damerau-Levenshtein would say 2
}

TEST_CASE("three hundred typos lead back to their name in 95 of 100 cases") {
    std::mt19937 random(20260101);
    int right = 0;
    for (int i = 0; i < 300; ++i) {
        const std::string& name = names[random() % names.size()];
        right += nearest_name(mistyped(name, random), names) == name ? 1 : 0;
    }
    CHECK(right >= 285);
}

TEST_CASE("random words get no suggestion in 98 of 100 cases") {
    std::mt19937 random(20260102);
    int silent = 0;
    for (int i = 0; i < 1000; ++i) {
        silent += nearest_name(random_word(random, 3 + random() % 12), names).empty() ? 1 : 0;
    }
    CHECK(silent >= 980);
}

TEST_CASE("a word near to none, or to two, gets no suggestion") {
    CHECK(nearest_name("", names) == "");
    CHECK(nearest_name("quantum", names) == "");
    CHECK(nearest_name(std::string(100'000, 'a'), names) == "");
    CHECK(nearest_name("cg3", {"cg3a", "cg3b"}) == "");
    CHECK(nearest_name("rk4", names) == "rkmk/rk4");
    CHECK(nearest_name("Heavy-Top", names) == "heavy_top");
}
