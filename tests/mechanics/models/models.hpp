// SPDX-License-Identifier: BSD-3-Clause
//
// Models with every pattern of the joint graph (one joint, a chain, a star, a closed loop, a body with no joint), every
// kind of joint and every kind of force.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "mechanics/formulation.hpp"
#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/solve/forest.hpp"
#include "problems/problem.hpp"
#include "tests/mechanics/models/jointed.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace models {

inline ParameterValues defaults(const Problem& problem) { return demonstration_parameters(problem.description); }

inline Model standard(const std::string& name) {
    const ParameterValues values = defaults(problem(name));
    return problem(name).build(Parameters(values));
}

struct Named {
    std::string name;
    Model model;
};

/// A closed loop that rotates rigidly about the line through its two ground joints: the start that satisfies all
/// joints.
inline Model loop() {
    Model model = linked(4, {{ground, 0}, {0, 1}, {1, 2}, {2, 3}, {ground, 3}});
    const Vec3 P = model.joints.front().r_first, axis = model.joints.back().r_first - P;
    for (Body& body : model.bodies) {
        body.start.omega = body.start.R.transpose() * axis;
        body.start.v = axis.cross(body.start.x - P);
    }
    return model;
}

/// One load in each kind of axes on the last body.
inline Model loaded(Model model) {
    const int last = static_cast<int>(model.bodies.size()) - 1;
    model.loads.push_back({last, Load::Axes::space, Vec3(3, -1, 2), Vec3(1, 2, -1), Real(1) / 2, 3});
    model.loads.push_back({last, Load::Axes::body, Vec3(-1, 2, 1), Vec3(2, -1, 3), Real(1) / 4, 2});
    return model;
}

/// The registered problems with their defaults.
inline std::vector<Named> registered() {
    std::vector<Named> models;
    for (const Problem& entry : problems())
        models.push_back({entry.description.name, standard(entry.description.name)});
    return models;
}

/// Whether no constraint row is redundant.
inline bool has_independent_rows(const Model& model) {
    const ConstraintRank rank = make_system(model, "SO3xR3")->constraint_rank();
    return rank.rank == rank.rows;
}

/// Models of the tests only, with spherical joints or none.
inline std::vector<Named> spherical() {
    return {{"loaded top", loaded(standard("forced_heavy_top"))},
            {"loaded chain", loaded(linked(3, {{ground, 0}, {0, 1}, {1, 2}}))},
            {"chain", linked(5, {{ground, 0}, {0, 1}, {1, 2}, {2, 3}, {3, 4}})},
            {"mixed chain", linked(4, {{ground, 0}, {1, 0}, {1, 2}, {3, 2}})},
            {"star", linked(4, {{ground, 0}, {0, 1}, {0, 2}, {0, 3}})},
            {"loop", loop()},
            {"two anchors", linked(2, {{ground, 0}, {ground, 1}})},
            {"floating pair", linked(2, {{0, 1}})}};
}

inline std::vector<Named> of_tests() {
    std::vector<Named> models = spherical();
    // A body is the first one of a joint that is eliminated before the joint that holds it.
    models.push_back({"chain listed from its tip", linked(3, {{1, 2}, {0, 1}, {ground, 0}})});
    models.push_back({"driven", driven()});
    models.push_back({"rolling", rolling()});
    models.push_back({"gear and rack", meshing()});
    models.push_back({"closed loop", closed_loop()});
    models.push_back({"bent", bent("universal")});
    models.push_back({"softened", softened("cylindrical")});
    for (const JointType type : joint_types()) {
        if (type == "gear" || type == "rack") continue;  // which other joints are to hold: they are in "gear and rack"
        models.push_back({std::string(type.name()) + " joints", jointed(type)});
        models.push_back({std::string(type.name()) + " joints and springs", sprung(type)});
        models.push_back({std::string(type.name()) + " joints and dampers", damped(type)});
    }
    for (const JointType type : driven_types()) models.push_back({type.name(), jointed(type)});
    return models;
}

/// Whether the recursion over forests solves the model, in formulations that have constraints.
inline bool takes_recursion(const Model& model) { return all_spherical(model) && is_forest(model); }

/// The system with the solver for joints of any kind.
inline std::unique_ptr<System> general_system(const Model& model, const std::string& name,
                                              SolverChoice choice = SolverChoice::automatic) {
    return formulation(name).make_general(model, choice);
}

inline std::vector<std::string> applicable(const Model& model) {
    std::vector<std::string> names;
    for (const Formulation& entry : formulations())
        if (entry.why_not(model).empty()) names.push_back(entry.name);
    return names;
}

/// Models that every method must be able to step with h of about 1/100 s: rows are independent, as an implicit step
/// needs them, and no damper is stiff. Few kinds of joints: methods do not depend on the kind. In quad of at most three
/// bodies: more are slow, and the same code. Made once, since a method asks for them in every check.
inline const std::vector<Named>& for_methods() {
    static const std::vector<Named> made = [] {
        std::vector<Named> models;
        for (Named& named : registered())
            if (has_independent_rows(named.model) && named.name != "flyball_governor")
                models.push_back(std::move(named));
        for (Named& named : spherical()) models.push_back(std::move(named));
        models.push_back({"driven", driven()});
        models.push_back({"rolling", rolling()});
        models.push_back({"closed loop", closed_loop()});
        models.push_back({"revolute joints and dampers", damped("revolute")});
        if (KREISEL_QUAD) std::erase_if(models, [](const Named& named) { return named.model.bodies.size() > 3; });
        return models;
    }();
    return made;
}

inline std::vector<Named> all() {
    std::vector<Named> models = registered();
    for (Named& named : of_tests()) models.push_back(std::move(named));
    return models;
}

}  // namespace models
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
