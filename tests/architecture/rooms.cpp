// SPDX-License-Identifier: BSD-3-Clause
#include "tests/architecture/rooms.hpp"

#include <algorithm>

namespace architecture {

namespace {

constexpr bool talks = true;

const std::string names_of_cells = "plots/tables/names.hpp";
const std::string interface = "engine/engine.hpp";
const std::string geometry = "engine/geometry.hpp";
const std::string metrics = "engine/metrics/description.hpp";
const std::string motion = "mechanics/model/motion.hpp";
const std::string model_data = "mechanics/model/data.hpp";
const std::string turns = "mechanics/turns.hpp";
const std::string equations = "mechanics/system.hpp";
const std::string parts = "mechanics/parts";
const std::string axes = "mechanics/space_axes.hpp";
const std::string formulation = "mechanics/formulation.hpp";
const std::string actions = "mechanics/actions";
const std::string forwarding = "mechanics/forwarding_system.hpp";
const std::string peer_equations = "peers/equations.hpp";
const std::string peer_stepper = "peers/stepper.hpp";
const std::string double_only = "peers/double_only.hpp";
const std::string registered = "support/registered.hpp";
const std::string registration = "support/registration.hpp";
const std::string watch = "support/watch.hpp";

// From the bottom up; CONTRIBUTING.md draws the same.
const std::vector<Room>& rooms() {
    static const Names numbers = {"Eigen/", "boost/multiprecision/"};
    static const std::vector<Room> all = {
        {"support", {}, {"fmt/", "nettle/"}, talks},
        {"lie", {}, numbers},
        {parts, {registered, registration}, {}},
        {motion, {"lie"}, {}},
        {model_data, {}, {}},
        {"mechanics/forces", {motion, model_data, registered, registration, "lie"}, numbers},
        {"mechanics/model", {"mechanics/model", "mechanics/forces", parts, "lie"}, numbers},
        {"mechanics/joints", {"mechanics/model", parts, "lie"}, numbers},
        {turns, {"mechanics/model", "lie"}, {}},
        {equations, {"mechanics/model", "mechanics/joints", turns, "lie"}, numbers},
        {axes, {"lie"}, {}},
        {actions, {equations, "lie"}, numbers},
        {forwarding, {equations, axes, actions, "mechanics/solve/pivot_record.hpp"}, {}},
        {"mechanics/blocks", {"lie"}, numbers},
        {"mechanics/solve",
         {equations, "mechanics/blocks", "mechanics/model", "mechanics/joints", "mechanics/forces", "lie"},
         numbers},
        {"mechanics/free_body", {equations, "lie"}, {"Eigen/", "boost/multiprecision/", "boost/math/"}},
        {formulation, {equations, "mechanics/blocks/solver_choice.hpp", registration}, {}},
        {"mechanics/formulations",
         {equations, axes, actions, forwarding, formulation, "mechanics/model", "mechanics/joints", "mechanics/forces",
          "mechanics/solve", "lie"},
         numbers},
        {"mechanics", {"mechanics", "lie", registered, registration}, numbers},
        {"problems/reading", {"mechanics", "lie"}, numbers},
        {"problems",
         {"problems", "mechanics", "lie", registered, registration},
         {"Eigen/", "boost/multiprecision/", "boost/math/"}},
        {"methods/tableaus", {"lie"}, numbers},
        {"methods/contract", {"methods/tableaus", "mechanics", "lie", registered, registration}, numbers},
        {"methods/conditions", {"methods/tableaus/tableau.hpp", "methods/contract/description.hpp"}, numbers},
        {"methods/control", {"methods/contract", "mechanics", "lie"}, numbers},
        {"methods/implicit", {"methods/contract/state_space.hpp", "mechanics", "lie"}, numbers},
        {"methods",
         {"methods/contract", "methods/conditions", "methods/control", "methods/tableaus", "methods/implicit",
          "mechanics", "lie"},
         numbers},
        {"peers/odeint", {peer_stepper, double_only, "methods", "mechanics", "lie"}, {"boost/numeric/odeint/"}},
        {"peers/gsl", {peer_stepper, double_only, "methods", "mechanics", "lie"}, {"gsl/"}},
        {"peers/sundials",
         {peer_stepper, peer_equations, double_only, "methods", "mechanics", "lie"},
         {"arkode/", "cvode/", "ida/", "nvector/", "sundials/", "sunlinsol/", "sunmatrix/", "sunnonlinsol/"}},
        {"peers", {"methods", "mechanics", "lie"}, numbers},
        {metrics, {}, {}},
        {geometry, {model_data}, {}},
        {interface,
         {geometry, metrics, model_data, "methods/contract/description.hpp", "problems/description.hpp", watch},
         {}},
        {"engine/report", {interface, geometry, "mechanics", "lie"}, numbers},
        {"engine/structure", {"mechanics", "lie"}, numbers},
        {"engine/metrics",
         {interface, metrics, "engine/report", "engine/structure", "mechanics", "lie", registered, registration},
         numbers},
        {"engine/reference", {interface, "engine/report", "mechanics", "lie", watch}, numbers},
        {"engine/observers",
         {interface, "engine/metrics", "engine/report", "mechanics", "lie", "support/pattern.hpp"},
         numbers,
         talks},
        {"engine",
         {"engine", "methods", "problems", "mechanics", "lie", "support/pattern.hpp", "support/number_text.hpp"},
         numbers,
         talks},
        {"records/fits", {"support"}, {"fmt/", "gsl/"}, talks},
        {"records/json",
         {interface, parts, model_data, "problems/description.hpp", "support"},
         {"fmt/", "nlohmann/"},
         talks},
        {"records/kinds", {"support"}, {}},
        {"records/metrics", {interface, "support"}, {}, talks},
        {"records/rows", {}, {}},
        {"records/sums", {"support"}, {"fmt/"}, talks},
        {"records/cell", {"records/json", "records/metrics", "records/sums", interface, "support"}, {"fmt/"}, talks},
        {"records/diff", {"records", interface, "support"}, {"fmt/"}, talks},
        {"records/folder", {"records", interface, "support"}, {"fmt/"}, talks},
        {"records/remarks", {"records", "support"}, {"fmt/"}, talks},
        {"records", {"records", interface, geometry, "support"}, {"fmt/", "nlohmann/"}, talks},
        {names_of_cells, {"records", "support"}, {"fmt/"}, talks},
        {"plots/laws", {names_of_cells, "records", "support"}, {"fmt/"}, talks},
        {"plots/tables", {"plots/laws", names_of_cells, "records", "support"}, {"fmt/"}, talks},
        {"plots/diff", {"plots/tables", "records", "support"}, {"fmt/"}, talks},
        {"plots/figures/kinds",
         {"plots/figures", "plots/laws", "plots/mechanism", names_of_cells, "records", "support"},
         {"fmt/"},
         talks},
        {"plots/figures", {names_of_cells, "records", "support"}, {"fmt/", "nlohmann/", "boost/tokenizer.hpp"}, talks},
        {"plots/mechanism", {geometry, "records/json/model.hpp", "support"}, {}},
        {"plots/report",
         {"plots/figures", "plots/mechanism", "plots/tables", "plots/wanting.hpp", "records", parts, "support"},
         {"fmt/", "nlohmann/"},
         talks},
        {"plots", {"plots", "records", "support"}, {"fmt/"}, talks},
        {"driver/config/urdf",
         {"records/json", "support"},
         {"boost/locale/utf.hpp", "boost/qvm/", "fmt/", "nlohmann/", "pugixml.hpp"},
         talks},
        {"driver/config",
         {"driver/config/urdf", "plots/figures/kind.hpp", "plots/figures/spec.hpp", "plots/figures/schema.hpp",
          "plots/figures/overlay/overlay_files.hpp", "records", interface, "methods/contract/description.hpp",
          "problems/description.hpp", "support"},
         {"fmt/", "gsl/", "nlohmann/"},
         talks},
        {"driver/plan", {"driver/config", "plots", "records", interface, "support"}, {"fmt/", "nlohmann/"}, talks},
        {"driver/campaign/workers", {"support"}, {"fmt/"}, talks},
        {"driver/campaign",
         {"driver/campaign/workers", "driver/plan", "driver/config", "records", interface, "support"},
         {"fmt/", "nlohmann/"},
         talks},
        {"driver/cli", {"driver", "plots", "records", interface, "support"}, {"CLI/", "fmt/", "nlohmann/"}, talks},
        {"driver", {"driver", interface}, {}, talks},
    };
    return all;
}

}  // namespace

bool lies_in(const std::string& path, const std::string& place) {
    return path == place || path.starts_with(place + "/");
}

const Room* room_of(const std::string& path) {
    const Room* best = nullptr;
    for (const Room& room : rooms()) {
        if (lies_in(path, room.name) && (best == nullptr || room.name.size() > best->name.size())) { best = &room; }
    }
    return best;
}

std::size_t capacity_of(const std::string& folder) {
    static const Names registries = {"problems",         "engine/metrics",    "mechanics/parts/joints",
                                     "mechanics/forces", "records/kinds",     "plots/figures/kinds",
                                     "plots/tables",     "tests/judges/steps"};
    // What families share.
    static const Names shared = {"methods/conditions", "methods/contract", "methods/control", "methods/implicit",
                                 "methods/tableaus"};
    const bool is_family =
        folder.starts_with("methods/") &&
        std::none_of(shared.begin(), shared.end(), [&](const std::string& place) { return lies_in(folder, place); });
    const bool is_registry = std::find(registries.begin(), registries.end(), folder) != registries.end();
    return is_family || is_registry ? 40 : 20;
}

const Names& outbuildings() {
    static const Names folders = {"tests", "benchmarks", "tools"};
    return folders;
}

}  // namespace architecture
