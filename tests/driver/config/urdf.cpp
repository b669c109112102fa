// SPDX-License-Identifier: BSD-3-Clause
//
// Robots from URDF files: where bodies and joints are and how they move, by closed forms; what cannot be taken is named
// with its line.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "driver/config/urdf/mechanism.hpp"
#include "kreisel_build.hpp"
#include "support/errors.hpp"
#include "tests/driver/command_line.hpp"

namespace robots_from_urdf {

using namespace kreisel;
using Catch::Contains;
using nlohmann::json;

namespace {

std::string link(const std::string& name, const std::string& inertial = "") {
    return "<link name=\"" + name + "\">" + inertial + "</link>\n";
}

std::string inertial(const std::string& mass, const std::string& origin = "0 0 0") {
    return "<inertial><origin xyz=\"" + origin + "\"/><mass value=\"" + mass +
           "\"/><inertia ixx=\"0.1\" ixy=\"0.01\" ixz=\"0\" iyy=\"0.2\" iyz=\"0\" izz=\"0.25\"/></inertial>";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& more = "") {
    return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" +
           child + "\"/>" + more + "</joint>\n";
}

std::string robot(const std::string& parts) { return "<robot name=\"r\">\n" + parts + "</robot>\n"; }

/// Two arms of length 2 and 1 that turn about z, a disk fixed to the second, a slide along its x.
std::string two_arms() {
    const std::string z = "<axis xyz=\"0 0 2\"/>";
    return robot(
        link("world") + link("upper", inertial("2", "1 0 0")) + link("lower", inertial("1", "0.5 0 0")) +
        link("disk", inertial("3")) + link("slide", inertial("0.5")) +
        joint("shoulder", "revolute", "world", "upper", z + "<origin xyz=\"0 0 1\"/>") +
        joint("elbow", "continuous", "upper", "lower", z + "<origin xyz=\"2 0 0\"/><dynamics damping=\"0.3\"/>") +
        joint("weld", "fixed", "lower", "disk", "<origin xyz=\"1 0 0\" rpy=\"0 0 1.5707963267948966\"/>") +
        joint("rail", "prismatic", "disk", "slide", "<axis xyz=\"0 -1 0\"/><dynamics damping=\"4\"/>"));
}

urdf::Mechanism mechanism(const std::string& text, const urdf::Start& start = {}) {
    const ScratchFolder scratch;
    return urdf::read_mechanism(scratch.file("r.urdf", text), start);
}

std::string complaint(const std::string& text, const urdf::Start& start = {}) {
    try {
        mechanism(text, start);
    } catch (const UsageError& error) { return error.what(); }
    return "";
}

void check_near(const json& values, const std::vector<double>& expected) {
    REQUIRE(values.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CHECK(values.at(i).get<double>() == Approx(expected[i]).epsilon(1e-14).margin(1e-15));
    }
}

const double pi = std::acos(-1.0);

}  // namespace

TEST_CASE("a robot has its bodies where its joints put them, moving as their rates say", "[urdf]") {
    const double a = 0.3, b = -0.7, s = 0.2, da = 1.1, db = 0.4, ds = -0.6;
    const json all = mechanism(two_arms(), {.positions = {{"shoulder", a}, {"elbow", b}, {"rail", s}},
                                            .rates = {{"shoulder", da}, {"elbow", db}, {"rail", ds}},
                                            .holds_root = {}})
                         .parameters;
    const json& upper = all.at("bodies").at(0);
    CHECK(upper.at("name") == "upper");
    check_near(upper.at("x"), {std::cos(a), std::sin(a), 1});
    check_near(upper.at("v"), {-da * std::sin(a), da * std::cos(a), 0});
    check_near(upper.at("omega"), {0, 0, da});
    // The second arm and the disk on it, at 1/2 and 1 of its length: their centre is at (1/2 + 3)/4.
    const json& lower = all.at("bodies").at(1);
    const double at = 3.5 / 4, phi = a + b, turn = da + db;
    const double x = 2 * std::cos(a) + at * std::cos(phi), y = 2 * std::sin(a) + at * std::sin(phi);
    CHECK(lower.at("mass") == 4);
    check_near(lower.at("x"), {x, y, 1});
    check_near(lower.at("v"), {-2 * da * std::sin(a) - turn * at * std::sin(phi),
                               2 * da * std::cos(a) + turn * at * std::cos(phi), 0});
    check_near(lower.at("omega"), {0, 0, turn});
    // By the parallel axes, in axes of the arm, in which the disk is turned by 90 degrees.
    const double apart = 0.5 * 0.5 * (1.0 * 3.0) / 4;
    check_near(lower.at("inertia").at(0), {0.1 + 0.2, 0.01 - 0.01, 0});
    check_near(lower.at("inertia").at(1), {0, 0.2 + 0.1 + apart, 0});
    check_near(lower.at("inertia").at(2), {0, 0, 0.25 + 0.25 + apart});
    // The disk's -y is the arm's x.
    const json& slide = all.at("bodies").at(2);
    const double out = 1 + s;
    check_near(slide.at("x"), {2 * std::cos(a) + out * std::cos(phi), 2 * std::sin(a) + out * std::sin(phi), 1});
    check_near(slide.at("v"), {-2 * da * std::sin(a) - turn * out * std::sin(phi) + ds * std::cos(phi),
                               2 * da * std::cos(a) + turn * out * std::cos(phi) + ds * std::sin(phi), 0});
    check_near(slide.at("R").at(0), {std::cos(phi + pi / 2), -std::sin(phi + pi / 2), 0});
}

TEST_CASE("joints of a robot connect its bodies, with their dampers", "[urdf]") {
    const json all = mechanism(two_arms()).parameters;
    const json& joints = all.at("joints");
    REQUIRE(joints.size() == 3);
    CHECK(joints[0].at("type") == "revolute");
    CHECK(joints[0].at("between") == json{"ground", "upper"});
    check_near(joints[1].at("point"), {2, 0, 1});
    check_near(joints[1].at("axis"), {0, 0, 1});
    CHECK(joints[2].at("type") == "prismatic");
    CHECK(joints[2].at("between") == json{"lower", "slide"});
    check_near(joints[2].at("axis"), {1, 0, 0});
    const json& forces = all.at("forces");
    REQUIRE(forces.size() == 2);
    CHECK(forces[0] == json{{"type", "rotational_damper"}, {"between", {"upper", "lower"}}, {"damping", 0.3}});
    CHECK(forces[1].at("type") == "damper");
    CHECK(forces[1].at("damping") == 4);
    CHECK_FALSE(all.at("bodies").at(0).contains("v"));
}

TEST_CASE("a small link with the inertia of a large one is shown about its joint's axis, a wheel as it is", "[urdf]") {
    const auto shown = [&](const std::string& parts) {
        const std::string ends = link("world") + joint("pan", "revolute", "world", "wrist", "<axis xyz=\"0 2 0\"/>");
        return mechanism(robot(link("wrist", inertial("1")) + ends + parts)).parameters.at("bodies").at(0);
    };
    const auto carrying = [&](const std::string& at) {
        return link("tool") + joint("flange", "fixed", "wrist", "tool", "<origin xyz=\"" + at + "\"/>");
    };
    const json wrist = shown(carrying("0 0 0.1"));
    CHECK(wrist.at("shape").at("type") == "cylinder");
    CHECK(wrist.at("shape").at("length") == 0.1);
    CHECK(wrist.at("shape").at("radius").get<double>() == Approx(0.04));
    check_near(wrist.at("shape").at("axis"), {0, 1, 0});
    // Its radius of gyration is sqrt((0.1 + 0.2 + 0.25)/2) m = 0.52 m.
    CHECK_FALSE(shown(carrying("0 0 0.2")).contains("shape"));
    CHECK_FALSE(shown("").contains("shape"));
}

TEST_CASE("a link looks as its geometry about its mass centre, and not as one that lies elsewhere", "[urdf]") {
    const auto shown = [&](const std::string& origin, const std::string& geometry, const std::string& tag = "visual") {
        const std::string drawn =
            "<" + tag + "><origin " + origin + "/><geometry>" + geometry + "</geometry></" + tag + ">";
        const std::string parts = link("world") + link("arm", inertial("1", "0.5 0 0") + "<visual/>" + drawn) +
                                  joint("j", "revolute", "world", "arm");
        const json body = mechanism(robot(parts)).parameters.at("bodies").at(0);
        return body.contains("shape") ? body.at("shape") : json();
    };
    const std::string box = "<box size=\"1 0.2 0.1\"/>", quarter = "rpy=\"0 0 1.5707963267948966\"";
    CHECK(shown("xyz=\"0.5 0 0\"", box) == json{{"type", "box"}, {"size", {1, 0.2, 0.1}}});
    CHECK(shown("xyz=\"0.5 0 0\" " + quarter, box, "collision") == json{{"type", "box"}, {"size", {0.2, 1, 0.1}}});
    CHECK(shown("xyz=\"0.5 0 0\" rpy=\"0 0 1.57\"", box) == json{{"type", "box"}, {"size", {0.2, 1, 0.1}}});
    CHECK(shown("xyz=\"0.5 0 0\" rpy=\"0 0 0.3\"", box).is_null());
    CHECK(shown("xyz=\"0.4 0 0\"", box).is_null());
    CHECK(shown("xyz=\"0.5 0 0\"", "<sphere radius=\"0.3\"/>") == json{{"type", "sphere"}, {"radius", 0.3}});
    CHECK(shown("xyz=\"0.5 0 0\"", "<sphere radius=\"0\"/>").is_null());
    CHECK(shown("xyz=\"0.5 0 0\"", "<mesh filename=\"arm.stl\"/>").is_null());
    const json rod = shown("xyz=\"0.5 0 0\" rpy=\"0 1.5707963267948966 0\"", "<cylinder radius=\"0.1\" length=\"2\"/>");
    CHECK((rod.at("type") == "cylinder" && rod.at("radius") == 0.1 && rod.at("length") == 2));
    check_near(rod.at("axis"), {1, 0, 0});
    CHECK_THAT(complaint(robot(link("arm", inertial("1") + "<visual><geometry><sphere radius=\"big\"/></geometry>"
                                                           "</visual>"))),
               Contains("<sphere>: expected a number as radius, got \"big\""));
}

TEST_CASE("roll, pitch and yaw turn about the axes of the parent, in this order", "[urdf]") {
    const json all = mechanism(robot(link("a") + link("b", inertial("1")) +
                                     joint("j", "revolute", "a", "b", "<origin rpy=\"0.2 -0.5 1.3\"/>")))
                         .parameters;
    const double r = 0.2, p = -0.5, y = 1.3;
    const auto c = [](double t) { return std::cos(t); };
    const auto s = [](double t) { return std::sin(t); };
    const json& R = all.at("bodies").at(0).at("R");
    check_near(R.at(0), {c(y) * c(p), c(y) * s(p) * s(r) - s(y) * c(r), c(y) * s(p) * c(r) + s(y) * s(r)});
    check_near(R.at(2), {-s(p), c(p) * s(r), c(p) * c(r)});
}

TEST_CASE("a root with mass is free, one without is the ground, and either can be said", "[urdf]") {
    const std::string text =
        robot(link("base", inertial("5")) + link("arm", inertial("1")) + joint("j", "revolute", "base", "arm"));
    const auto names = [&](std::optional<bool> holds_root, const std::string& robot) {
        std::string all;
        const json parameters = mechanism(robot, {.positions = {}, .rates = {}, .holds_root = holds_root}).parameters;
        for (const json& body : parameters.at("bodies")) { all += body.at("name").get<std::string>() + " "; }
        return all;
    };
    CHECK(names({}, text) == "base arm ");
    CHECK(names(true, text) == "arm ");
    CHECK(names({}, two_arms()) == "upper lower slide ");
    CHECK(names({}, robot(link("world") + link("ball", inertial("1")) + joint("j", "floating", "world", "ball"))) ==
          "ball ");
    CHECK_THAT(complaint(two_arms(), {.positions = {}, .rates = {}, .holds_root = false}),
               Contains("<link \"world\">: expected a mass"));
}

TEST_CASE("the arm that is shipped has its wrist where the product of exponentials puts it", "[urdf]") {
    // The home position of the last mass centre and the screw of the shoulder, which is the line along y at the height
    // 0.089159, as printed for simulations of this arm (Lynch, Park, Modern Robotics).
    const double q = -1, x = 0.81725, z = -0.005491 - 0.089159;
    const json bodies =
        urdf::read_mechanism(std::filesystem::path(build::source_dir) / "experiments/mechanisms/ur5.urdf",
                             {.positions = {{"shoulder_lift", q}}, .rates = {}, .holds_root = {}})
            .parameters.at("bodies");
    REQUIRE(bodies.size() == 6);
    CHECK(bodies.at(5).at("name") == "wrist_3_link");
    check_near(bodies.at(5).at("x"), {x * std::cos(q) + z * std::sin(q), 0.13585 - 0.1197 + 0.093,
                                      0.089159 - x * std::sin(q) + z * std::cos(q)});
}

TEST_CASE("what a robot has beside its motion is left out, with a word where it would change it", "[urdf]") {
    const std::string drawn = "<visual><geometry><box size=\"1 1 1\"/></geometry></visual><collision/>";
    const auto remarks = [](const std::string& parts) { return mechanism(robot(parts)).remarks; };
    const std::string base = link("a") + link("b", inertial("1") + drawn);
    CHECK(remarks(base + "<material name=\"red\"/>" + joint("j", "revolute", "a", "b")).empty());
    const auto all = remarks(base + "<transmission name=\"t\"/>" +
                             joint("j", "revolute", "a", "b", "<limit upper=\"1\"/><dynamics friction=\"2\"/>"));
    REQUIRE(all.size() == 3);
    CHECK_THAT(all[0], Contains("r.urdf: <transmission> has no part in the motion"));
    CHECK_THAT(all[1], Contains("the dry friction of <joint \"j\"> is left out"));
    CHECK_THAT(all[2], Contains("joints move past their <limit>"));
}

TEST_CASE("each robot that cannot be taken is refused at its line", "[urdf]") {
    const std::string a = link("a"), b = link("b", inertial("1")), c = link("c", inertial("1"));
    const std::string j = joint("j", "revolute", "a", "b");
    const std::pair<std::string, std::string> bad[] = {
        {"<robot><link", "r.urdf:1: expected XML, got an error"},
        {"<robot>\n<link>\n</robot>", "r.urdf:3: expected XML, got an error"},
        {"", "r.urdf:1: expected <robot>, got no element"},
        {robot(a + b + j) + "\n<robot/>", "expected one element <robot>, got <robot> beside it"},
        {robot(a + b + j) + "junk", "expected one element <robot>, got text beside it"},
        {robot("\n<link name=\"\xE4rm\"/>"), "r.urdf:3: expected UTF-8 text, got the byte 0xE4"},
        {robot(a + "\n<link name=\"\xFF\"/>"), "expected UTF-8 text, got the byte 0xFF"},
        {robot(a + std::string(1, '\0')), "expected UTF-8 text, got a zero byte"},
        {robot(a + "<link name=\"b\" name=\"c\"/>"),
         "r.urdf:3: <link \"b\">: expected each attribute once, got name twice"},
        {"<robt/>", "r.urdf:1: <robt>: expected <robot>, got <robt>"},
        {robot(a + b + joint("j", "planar", "a", "b")), "r.urdf:4: <joint \"j\">: expected a joint that is revolute"},
        {robot(a + b + joint("j", "revolut", "a", "b")), "got \"revolut\"; did you mean \"revolute\"?"},
        {robot(a + b + joint("j", "revolute", "a", "bb")), "expected the name of a link, got \"bb\""},
        {robot(a + b + j + joint("k", "revolute", "a", "b")), "r.urdf:5: <joint \"k\">: expected a tree"},
        {robot(a + b + c + j), "expected one link that no joint carries, got \"a\", \"c\""},
        {robot(a + b + c + joint("j", "revolute", "b", "c") + joint("k", "revolute", "c", "b")),
         "expected joints that lead from \"a\" to every link, got none to \"b\", \"c\""},
        {robot(a + b + b + j), "r.urdf:4: expected links with different names, got a second \"b\""},
        {robot(a + link("b") + j), "r.urdf:3: <link \"b\">: expected a mass"},
        {robot(a + link("b", inertial("-1")) + j), "<mass>: expected a mass that is not negative, got -1"},
        {robot(a + link("b", inertial("one")) + j), "<mass>: expected a number as value, got \"one\""},
        {robot(a + link("b", inertial("1", "0 0")) + j), "<origin>: expected three numbers as xyz, got \"0 0\""},
        {robot(a + link("b", "<inertial><mass value=\"1\"/></inertial>") + j),
         "expected an element <inertia>, got none"},
        {robot(a + b + joint("j", "revolute", "a", "b", "<axis xyz=\"0 0 0\"/>")), "expected a direction as xyz"},
        {robot(a + b + joint("j", "revolute", "a", "b", "<mimic joint=\"k\"/>")), "got one with <mimic>"},
        {robot(a + b + joint("j", "revolute", "a", "b", "<orign xyz=\"1 0 0\"/>")), "expected <origin>, got <orign>"},
        {robot(a + b + joint("j", "revolute", "a", "b", "<dynamics damping=\"-1\"/>")), "got -1"},
        {robot(a + b + joint("j", "revolute", "a", "b", "<origin xyz=\"1 nan 0\"/>")), "got \"nan\""}};
    for (const auto& [text, expected] : bad) {
        INFO(text);
        CHECK_THAT(complaint(text), Contains(expected));
    }
    CHECK(complaint(robot(a + b + j)).empty());
    CHECK(complaint("\xEF\xBB\xBF<?xml version=\"1.0\"?>\n" + robot("<!-- \xC3\xA4 -->" + a + b + j)).empty());
    CHECK_THAT(complaint(robot(a + b + j), {.positions = {{"k", 1}}, .rates = {}, .holds_root = {}}),
               Contains("positions: expected the name of a joint that turns or slides, got \"k\""));
}

}  // namespace robots_from_urdf
