// SPDX-License-Identifier: BSD-3-Clause
//
// Shapes of bodies, poses and motions as the page of a report holds them.
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <random>

#include "plots/mechanism/outline.hpp"
#include "plots/mechanism/shape.hpp"
#include "plots/report/forces.hpp"
#include "plots/report/motion.hpp"
#include "plots/report/poses.hpp"
#include "records/geometry.hpp"
#include "records/json/exact.hpp"
#include "records/reading/read_results.hpp"
#include "records/reading/trajectory_table.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

// A rotation by its quaternion, row by row.
Matrix3 rotation_of(const std::array<double, 4>& q) {
    const auto [w, x, y, z] = q;
    return {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),
            2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
            2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y)};
}

std::array<double, 4> drawn_quaternion(std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::array<double, 4> q{};
    double square = 0;
    for (double& part : q) {
        part = normal(random);
        square += part * part;
    }
    for (double& part : q) { part /= std::sqrt(square); }
    return q;
}

// R diag(J) R^T.
Matrix3 turned_inertia(const Vector3& J, const Matrix3& R) {
    Matrix3 turned{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) { turned[3 * i + j] += R[3 * i + k] * J[k] * R[3 * j + k]; }
        }
    }
    return turned;
}

double dot_product(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The inverse of base64, of numbers.
template <class T>
std::vector<T> unpacked(const std::string& text) {
    static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0, held = 0;
    for (const char c : text) {
        if (c == '=') { break; }
        bits = (bits << 6U) | static_cast<unsigned>(digits.find(c));
        held += 6;
        if (held >= 8) { bytes += static_cast<char>((bits >> (held -= 8)) & 0xffU); }
    }
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

}  // namespace

TEST_CASE("a homogeneous solid is found again from its mass and inertia, however it lies in the body") {
    std::mt19937 random(1);
    for (int i = 0; i < 20; ++i) {
        const Matrix3 R = i == 0 ? identity3 : rotation_of(drawn_quaternion(random));
        const double m = 3, a = 0.5, b = 1, c = 2;
        const Vector3 box = {m * (b * b + c * c) / 12, m * (a * a + c * c) / 12, m * (a * a + b * b) / 12};
        BodyShape shape = shape_of({"box", m, turned_inertia(box, R)});
        CHECK(shape.kind == BodyShape::Kind::box);
        Vector3 sorted = shape.sizes;
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t k = 0; k < 3; ++k) { CHECK(std::abs(sorted[k] - Vector3{a, b, c}[k]) < 1e-12); }
        const double r = 0.3, h = 1.5, J = m * (3 * r * r + h * h) / 12;
        shape = shape_of({"cylinder", m, turned_inertia({J, m * r * r / 2, J}, R)});
        CHECK(shape.kind == BodyShape::Kind::cylinder);
        CHECK(std::abs(shape.sizes[0] - 2 * r) < 1e-8);
        CHECK(std::abs(shape.sizes[2] - h) < 1e-8);
        CHECK(std::abs(std::abs(dot_product(shape.axes[2], {R[1], R[4], R[7]})) - 1) < 1e-12);
        const double sphere = 0.4 * m * r * r;
        shape = shape_of({"ball", m, turned_inertia({sphere, sphere, sphere}, R)});
        CHECK(shape.kind == BodyShape::Kind::sphere);
        CHECK(std::abs(shape.sizes[0] - 2 * r) < 1e-12);
        for (std::size_t k = 0; k < 3; ++k) { CHECK(std::abs(dot_product(shape.axes[k], shape.axes[k]) - 1) < 1e-12); }
    }
    CHECK(shape_of({"point", 1, {}}).kind == BodyShape::Kind::point);
    CHECK(shape_of({"none", 0, identity3}).kind == BodyShape::Kind::point);
}

TEST_CASE("a body has the shape that it is given, whatever its inertia") {
    const BodyGeometry body{"b", 1, identity3};
    const auto drawn = [&](const ShapeData& shape) { return shape_of(body, {{"b", shape}}); };
    const BodyShape rod = drawn({.type = "rod", .length = 3, .axis = Vector3{0, 3, 4}});
    CHECK(rod.kind == BodyShape::Kind::cylinder);
    CHECK(rod.sizes == Vector3{0.12, 0.12, 3});
    CHECK(std::abs(dot_product(rod.axes[2], {0, 0.6, 0.8}) - 1) < 1e-15);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(dot_product(rod.axes[i], rod.axes[i]) - 1) < 1e-15);
        CHECK(std::abs(dot_product(rod.axes[i], rod.axes[(i + 1) % 3])) < 1e-15);
    }
    const BodyShape cylinder = drawn({.type = "cylinder", .radius = 0.5, .length = 2});
    CHECK(cylinder.sizes == Vector3{1, 1, 2});
    CHECK(cylinder.axes[2] == Vector3{0, 0, 1});
    CHECK(drawn({.type = "sphere", .radius = 2}).kind == BodyShape::Kind::sphere);
    const BodyShape box = drawn({.type = "box", .size = Vector3{1, 2, 0.001}});
    CHECK(box.kind == BodyShape::Kind::box);
    CHECK(box.sizes == Vector3{1, 2, 0.001});  // not made thicker
    CHECK(shape_of(body, {{"other", {.type = "box", .size = Vector3{1, 2, 3}}}}).kind == BodyShape::Kind::sphere);
    CHECK(outline_of(body, {{body}, {}}, {{"b", {.type = "box", .size = Vector3{1, 2, 3}}}}).size() == 12);
}

TEST_CASE("quaternions turn as their rotations, and follow the one before") {
    std::mt19937 random(2);
    for (int i = 0; i < 200; ++i) {
        const auto q = drawn_quaternion(random), near = drawn_quaternion(random);
        const Matrix3 R = rotation_of(q), again = rotation_of(quaternion_of(R, near));
        for (std::size_t k = 0; k < 9; ++k) { CHECK(std::abs(R[k] - again[k]) < 1e-14); }
        const auto found = quaternion_of(R, near);
        CHECK(found[0] * near[0] + found[1] * near[1] + found[2] * near[2] + found[3] * near[3] >= 0);
    }
    CHECK(quaternion_of({std::nan(""), 0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 0, 0}) == std::array<double, 4>{0, 1, 0, 0});
}

TEST_CASE("thinned samples begin and end with the first and the last") {
    for (std::size_t samples = 1; samples < 700; ++samples) {
        for (const std::size_t most : {2U, 3U, 7U, 100U, 500U}) {
            const auto indices = thinned(samples, most);
            CAPTURE(samples, most);
            REQUIRE((indices.front() == 0 && indices.back() == samples - 1 && indices.size() <= most));
            if (samples <= most) { REQUIRE(indices.size() == samples); }
            const std::size_t step = indices.size() > 1 ? indices[1] : 1;
            for (std::size_t i = 1; i + 1 < indices.size(); ++i) { REQUIRE(indices[i] == i * step); }
        }
    }
}

TEST_CASE("a motion is on the page with the poses of its samples and the shapes of its bodies") {
    const ResultFolder folder;
    const std::string line = result_line("a1", 64, 1e-3, {{"trajectory", "trajectories/a1.csv"}}).dump() + "\n";
    folder.write("results.jsonl", line);
    folder.write("trajectories/a1.csv", trajectory_text(50));
    const Geometry top{{{"top", 2, {0.2, 0, 0, 0, 0.1, 0, 0, 0, 0.2}}},
                       {{"pin", "spherical", {"ground", "top"}, {Vector3{0, 0, 0}, Vector3{0, -1, 0}}},
                        {"pull", "a force", {"ground", "top"}, {Vector3{0, 0, 1}, Vector3{0, 0, 0}}}}};
    const Shapes boxes = {{"top", {.type = "box", .size = Vector3{0.1, 0.2, 0.3}}}};
    write_geometry(folder.path(), {{{"a1"}, top, boxes}});
    CHECK(read_geometry(folder.path()) == std::vector<CellGeometry>{{{"a1"}, top, boxes}});
    const auto given =
        nlohmann::json::parse(report_motion(read_results(folder.path()), folder.path(), room_for_motion(0)));
    CHECK(given.at("mechanisms").at(0).at("bodies").at(0).at("shape") == "box");
    CHECK(given.at("mechanisms").at(0).at("bodies").at(0).at("sizes") == nlohmann::json({0.1, 0.2, 0.3}));
    write_geometry(folder.path(), {{{"a1"}, top}});
    CHECK(read_geometry(folder.path()) == std::vector<CellGeometry>{{{"a1"}, top}});
    const auto motion =
        nlohmann::json::parse(report_motion(read_results(folder.path()), folder.path(), room_for_motion(0)));
    const auto& cell = motion.at("cells").at(0);
    CHECK(cell.at("mechanism") == 0);
    CHECK(cell.at("bodies") == nlohmann::json({"top"}));
    const auto t = unpacked<double>(cell.at("t")), x = unpacked<double>(cell.at("x"));
    const auto q = unpacked<std::int16_t>(cell.at("q"));
    const auto v = unpacked<float>(cell.at("v"));
    REQUIRE((t.size() == 51 && x.size() == 153 && q.size() == 204 && v.size() == 153));
    for (std::size_t i = 0; i < t.size(); ++i) {
        CHECK(t[i] == static_cast<double>(i) / 50);
        CHECK(std::abs(x[3 * i] + std::sin(t[i])) < 1e-15);
        CHECK(v[3 * i] == static_cast<float>(-std::cos(t[i])));
        CHECK(std::abs(q[4 * i] / 32767.0 - std::cos(t[i] / 2)) < 2e-5);
        CHECK(std::abs(q[4 * i + 3] / 32767.0 - std::sin(t[i] / 2)) < 2e-5);
    }
    CHECK(motion.at("mechanisms").at(0).at("bodies").at(0).at("shape") == "cylinder");
    CHECK(motion.at("mechanisms").at(0).at("links").at(0).at("force") == false);
    CHECK(motion.at("mechanisms").at(0).at("links").at(1).at("force") == true);
    CHECK(motion.at("remarks").empty());
    const auto narrow = nlohmann::json::parse(report_motion(read_results(folder.path()), folder.path(), 1000));
    CHECK(unpacked<double>(narrow.at("cells").at(0).at("t")).size() < 15);
    CHECK(narrow.at("remarks").size() == 1);
}

TEST_CASE("motions have less room on a page with many other data, but always some") {
    const std::size_t most = room_for_motion(0), others = 1500000;
    CHECK(room_for_motion(others / 2) == most);
    CHECK(room_for_motion(others) < most);
    CHECK(room_for_motion(others) + others <= 2350000);
    CHECK(room_for_motion(10 * others) > 0);
}

TEST_CASE("forces of joints are packed for the page, with what drives them, and weights and loads told") {
    TrajectoryTable samples;
    const auto add = [&](const std::string& name, std::vector<double> values) {
        samples.names.push_back(name);
        samples.units.emplace_back("1");
        samples.columns.push_back(std::move(values));
    };
    add("t", {0, 1, 2});
    for (int k = 1; k <= 3; ++k) { add("crank.x" + std::to_string(k), {1.0 * k, 0, 0}); }
    // A quarter turn about the third axis.
    for (const auto& [name, value] : {std::pair("R12", -1.0), std::pair("R21", 1.0), std::pair("R33", 1.0)}) {
        add(std::string("crank.") + name, {value, value, value});
    }
    for (int k = 1; k <= 3; ++k) {
        add("reaction.pin.force." + std::to_string(k), {1.0 * k, -300, std::nan("")});
        add("reaction.pin.torque." + std::to_string(k), {0, 1e-3, 1e300});
    }
    add("drive.pin.torque", {2, 3, 4});
    const Geometry mechanism{{{"crank", 1, identity3}},
                             {{"loose", "spring", {"ground", "crank"}}, {"pin", "revolute", {"ground", "crank"}}}};
    const auto forces = nlohmann::json::parse(forces_json(samples, mechanism, {"crank"}, {0, 1, 2}));
    REQUIRE(forces.size() == 1);
    CHECK(forces.at(0).at("link") == 1);
    CHECK_FALSE(forces.at(0).contains("force"));
    const auto number = [](std::uint16_t half) {
        return std::bit_cast<float>(static_cast<std::uint32_t>(half) << 16U);
    };
    const auto F = unpacked<std::uint16_t>(forces.at(0).at("F")), tau = unpacked<std::uint16_t>(forces.at(0).at("tau"));
    REQUIRE((F.size() == 9 && tau.size() == 9));
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(number(F[k]) == static_cast<float>(k + 1));
        CHECK(number(F[3 + k]) == Approx(-300).epsilon(1.0 / 256).margin(0));
        CHECK(number(tau[3 + k]) == Approx(1e-3).epsilon(1.0 / 256).margin(0));
        CHECK(std::isnan(number(F[6 + k])));
        CHECK(std::isnan(number(tau[6 + k])));
    }
    CHECK(number(unpacked<std::uint16_t>(forces.at(0).at("torque")).at(2)) == 4);
    CHECK(bytes_of_forces(samples) == 7 * 2 * 4 / 3);
    CHECK(forces_json(samples, mechanism, {"another"}, {0}) == "[]");
    for (std::size_t i = 0; i < samples.names.size(); ++i) {
        if (samples.names[i].find(".torque.") != std::string::npos) { samples.columns[i] = {0, 0, 0}; }
    }
    CHECK_FALSE(nlohmann::json::parse(forces_json(samples, mechanism, {"crank"}, {0, 1, 2})).at(0).contains("tau"));
    CHECK(bytes_of_forces(samples) == 4 * 2 * 4 / 3);
    for (int k = 1; k <= 3; ++k) { add("exerted.loose.force." + std::to_string(k), {-1.0 * k, 0, 0}); }
    const auto both = nlohmann::json::parse(forces_json(samples, mechanism, {"crank"}, {0, 1, 2}));
    REQUIRE(both.size() == 2);
    CHECK(both.at(0).at("link") == 0);
    CHECK_FALSE(both.at(0).contains("tau"));
    CHECK(number(unpacked<std::uint16_t>(both.at(0).at("F")).at(2)) == -3);
    CHECK(bytes_of_forces(samples) == 7 * 2 * 4 / 3);
    const JsonValue parameters = parse_exactly(R"({"gravity": [0, 0, -9.81], "gravity_amplitude": 0.5, "forces": [
        {"type": "force", "body": "crank", "value": [1, 2, 3], "frame": "space", "point": [1, 3, 3], "amplitude": 2,
         "frequency": 7},
        {"type": "spring", "between": ["ground", "crank"]}]})");
    const auto applied = nlohmann::json::parse(applied_json(parameters, samples));
    CHECK(applied.at("gravity") == nlohmann::json({{"g", {0, 0, -9.81}}, {"amplitude", 0.5}, {"frequency", 0}}));
    REQUIRE(applied.at("loads").size() == 1);
    CHECK(applied.at("loads").at(0).at("point") == nlohmann::json({1, 0, 0}));  // one metre along the second axis
    CHECK(applied.at("loads").at(0).at("force") == nlohmann::json({1, 2, 3}));
    CHECK(applied.at("loads").at(0).at("frequency") == 7);
}

TEST_CASE("a damaged geometry is not read, and bodies are then points") {
    const ResultFolder folder;
    write_geometry(folder.path(), {{{"a1"}, {{{"top", 2, identity3}}, {}}}});
    std::string text = folder.read("geometry.json");
    REQUIRE(read_geometry(folder.path()).size() == 1);
    text[text.find("top")] = 'T';
    folder.write("geometry.json", text);
    CHECK(read_geometry(folder.path()).empty());
    CHECK(geometry_of({}, "a1") == nullptr);
}

TEST_CASE("a body is outlined by the edges of its solid and lines to its joints") {
    const Geometry mechanism{{{"brick", 3, {5, 0, 0, 0, 4.25, 0, 0, 0, 1.25}}},
                             {{"pin", "spherical", {"ground", "brick"}, {Vector3{9, 9, 9}, Vector3{0, 0, -1}}}}};
    const auto lines = outline_of(mechanism.bodies[0], mechanism);
    REQUIRE(lines.size() == 13);
    CHECK(lines.back() == Polyline{{0, 0, 0}, {0, 0, -1}});
    double length = 0;
    for (std::size_t i = 0; i < 12; ++i) {
        const auto& [p, q] = std::pair(lines[i].at(0), lines[i].at(1));
        length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
    const double a = std::sqrt(6 * (4.25 + 1.25 - 5) / 3), b = std::sqrt(6 * (5 + 1.25 - 4.25) / 3),
                 c = std::sqrt(6 * (5 + 4.25 - 1.25) / 3);
    CHECK(std::abs(length - 4 * (a + b + c)) < 1e-12);
    const Polyline turned = moved({{1, 0, 0}}, {0, 0, 5}, {0, -1, 0, 1, 0, 0, 0, 0, 1});
    CHECK(turned == Polyline{{0, 1, 5}});
}

TEST_CASE("motion draws a mechanism without lever from its geometry, and says what it lacks") {
    const ResultFolder folder;
    folder.write("results.jsonl", result_line("a1", 64, 1e-3,
                                              {{"trajectory", "trajectories/a1.csv"},
                                               {"problem", "free_top"},
                                               {"parameters", {{"lever", nullptr}}}})
                                          .dump() +
                                      "\n");
    folder.write("trajectories/a1.csv", trajectory_text(50));
    const Results results = read_results(folder.path());
    const auto figure = figure_read_from({{"kind", "motion"}, {"instants", 3}});
    CHECK_THROWS_WITH(figure->write(results, folder.path()), Catch::Contains("geometry.json"));
    write_geometry(folder.path(), {{{"a1"}, {{{"top", 3, {5, 0, 0, 0, 4.25, 0, 0, 0, 1.25}}}, {}}}});
    figure->write(results, folder.path());
    const std::string lines = folder.read("plotdata/figure.tops.dat");
    CHECK(std::count(lines.begin(), lines.end(), '\n') == 3 * 12 * 3);
}
