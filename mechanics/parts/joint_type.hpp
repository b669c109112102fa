// SPDX-License-Identifier: BSD-3-Clause
//
// What a joint is: a recipe of primitive rows. With the points p of the two bodies, d = p_first - p_second, and the
// axes a_k of the first body and b_k of the second (k = 1, 2, 3; a_3, b_3 along the axis of the joint), in space axes:
//
//   coincidence        d = 0                             3 rows
//   along(k)           b_k.d = 0                         1 row
//   orthogonal(i, k)   a_i.b_k = 0                       1 row, which compares directions
//   distance           |d| = L (1 + A sin(W t))          1 row
//   contact            of a disk that rolls on a plane   3 rows, two of them without a position level
//   shift              b_3.d + f(t) = 0                  1 row, of a prescribed shift f
//   turn               f(t) - theta = 0                  1 row, which compares directions, of a prescribed turn f
//   helix              -2 pi b_3.d / lead - theta = 0    1 row, which compares directions
//   rack               2 pi a_3.d / lead - theta = 0     1 row, which compares directions; b_3 is across a_3
//   mesh               (z_1 psi_1 + z_2 psi_2)/z_2 = 0   1 row, which compares directions, of wheels with z teeth;
//                                                        psi is the angle of d in the first two axes of a body
//
// theta is the angle by which the second body has turned about the axis, which is zero where a_1 = b_1.
//
// mechanics/joints/row_writer.hpp and coordinate_rows.hpp write them, engine/reference/taylor/row_series.hpp derives
// them a second time. All else follows from the recipe: counts of rows, keys in configs, `kreisel info`, what a joint
// may hold, symmetries. A joint is one file in mechanics/parts/joints/; one whose coordinate is prescribed has a row
// for it in place of the free motion (driven_joints.hpp). Plain data, compiled once for all precisions.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mechanics/parts/keys.hpp"
#include "support/registered.hpp"
#include "support/registration.hpp"

namespace kreisel {

enum class Primitive { coincidence, along, orthogonal, distance, contact, shift, turn, helix, rack, mesh };

/// How many rows a primitive has.
int rows_in(Primitive primitive);

/// Rows of one primitive; i and k count from 0.
struct JointRow {
    Primitive primitive;
    int i = 0, k = 0;
    bool operator==(const JointRow&) const = default;
};

constexpr JointRow coincidence() { return {Primitive::coincidence}; }
constexpr JointRow along(int k) { return {Primitive::along, 0, k - 1}; }
constexpr JointRow orthogonal(int i, int k) { return {Primitive::orthogonal, i - 1, k - 1}; }
constexpr JointRow distance() { return {Primitive::distance}; }
constexpr JointRow contact() { return {Primitive::contact}; }
constexpr JointRow shift() { return {Primitive::shift}; }
constexpr JointRow turn() { return {Primitive::turn}; }
constexpr JointRow helix() { return {Primitive::helix}; }
constexpr JointRow rack() { return {Primitive::rack}; }
constexpr JointRow mesh() { return {Primitive::mesh}; }

/// What axes a user gives, and how they must lie at the start: none, one for both bodies (or one for each, to be
/// projected), one for each at a right angle, one for each that are not parallel.
enum class JointAxes { none, common, perpendicular, not_parallel };

/// Motions of one body relative to the other that all rows allow.
enum class FreeMotion {
    turn_about_point,   ///< about any line through the point: 3
    turn_about_axis,    ///< about the axis, which passes through the point: 1
    turn_about_two,     ///< about the axis of either body, through the point: 2
    turn_about_normal,  ///< about any line along the axis: 1, beside those across it
    slide_along_axis,   ///< 1
    slide_across_axis,  ///< 2
    swing,              ///< about no line that either body keeps: of a point on a sphere, 2
    roll,               ///< of a disk that does not slip: 3
    screw,              ///< about the axis and along it at once: 1
    mesh,               ///< all but what would let teeth slip: 5
};
/// The dimension of a free motion.
int count_of(FreeMotion motion);

struct JointRecipe {
    std::string name;
    std::string summary;
    int place = 100;  ///< in lists; joints of one place come by name
    JointAxes axes = JointAxes::none;
    std::vector<JointRow> rows = {};    ///< on the points, of one primitive, and then those that compare directions
    std::vector<FreeMotion> free = {};  ///< all of them: as many as 6 less the rows, which are independent
};

/// Why a recipe is wrong; empty: it is not. Rows are counted here; that they are independent and leave the declared
/// motions free is tested numerically (tests/mechanics/recipes.cpp).
std::string fault_of(const JointRecipe& recipe);

/// A recipe with what follows from it.
struct JointKind : JointRecipe {
    explicit JointKind(JointRecipe recipe);
    int row_count = 0, position_count = 0, length_count = 0;
    bool holds_points = false;  ///< no row asks for a rotation of a body, so that it may be a point mass
    ElementType element;        ///< its keys
    bool has(Primitive primitive) const;
    /// The first row of a primitive, counted from 0; -1 if there is none.
    int row_of(Primitive primitive) const;
    bool has(FreeMotion motion) const;
    /// Nothing but the coincidence of two points.
    bool is_ball() const { return rows.size() == 1 && has(Primitive::coincidence); }
};

/// One of the registered joints, by name: "revolute". Cheap to copy and to compare.
class JointType {
  public:
    /// Throws std::invalid_argument with the valid names if there is no such joint.
    JointType(const char* name) : JointType(std::string(name)) {}
    JointType(const std::string& name);
    explicit JointType(const JointKind& kind) : kind_(&kind) {}
    const JointKind* operator->() const { return kind_; }
    const char* name() const { return kind_->name.c_str(); }
    bool operator==(const JointType&) const = default;

  private:
    const JointKind* kind_;
};

/// All joints, in the order of their places. Throws std::logic_error if a recipe is wrong.
const std::vector<JointKind>& joint_kinds();
/// The joint of this name, or null.
const JointKind* find_joint_kind(const std::string& name);
std::vector<std::string> joint_names();
/// "spherical and distance".
std::string joints_that_hold_points();

struct JointRegistration {
    explicit JointRegistration(JointRecipe recipe) { Registered<JointKind>::add(JointKind(std::move(recipe))); }
};

/// KREISEL_JOINT({recipe}) in its file.
#define KREISEL_JOINT(...) KREISEL_REGISTER(::kreisel::JointRegistration, __VA_ARGS__)

}  // namespace kreisel
