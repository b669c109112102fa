// SPDX-License-Identifier: BSD-3-Clause
//
// The registered problems and the models of the tests, and states at which they are checked: their own start, and
// random poses and velocities brought onto the joints.
#pragma once

#include <catch2/catch.hpp>

#include "problems/problem.hpp"
#include "tests/judges/problems/checks.hpp"
#include "tests/mechanics/models/models.hpp"

namespace states {

using namespace kreisel;

using models::all;
using models::Named;

std::vector<std::string> applicable(const Model& model);

/// Bodies at a time, satisfying every joint at position and velocity level to round-off.
struct Pose {
    Real t;
    std::vector<BodyState> bodies;
};

/// The model's own start at t = 0 first, then `count` random ones at other times, always the same.
std::vector<Pose> poses(const Model& model, int count);

checks::At in_coordinates(const System& system, const Pose& pose);

/// f(system, state) for each model, formulation and pose, named in Catch's messages.
template <class F>
void for_each_state(F f) {
    for (const auto& [title, model] : all()) {
        const auto states = poses(model, 4);
        for (const std::string& name : applicable(model)) {
            const auto system = make_system(model, name);
            for (std::size_t i = 0; i < states.size(); ++i) {
                INFO(title << " as " << name << ", state " << i);
                f(*system, in_coordinates(*system, states[i]));
            }
        }
    }
}

}  // namespace states
