// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/row_series.hpp"

#include "engine/reference/taylor/rows/contact_rows.hpp"
#include "engine/reference/taylor/rows/mesh_row.hpp"
#include "engine/reference/taylor/rows/point_rows.hpp"
#include "engine/reference/taylor/rows/scalars.hpp"
#include "engine/reference/taylor/rows/turn_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// a . b = 0, t = a x b.
class OrthogonalRow final : public DirectionRowSeries {
  public:
    OrthogonalRow(const Joint& joint, const JointRow& row, const JointEnds& ends)
        : DirectionRowSeries(ends),
          a_(ends.first, joint.axes_first.col(row.i)),
          b_(ends.second, joint.axes_second.col(row.k)) {}
    void follow(const JointEnds&, std::size_t i) override { a_.update(i), b_.update(i); }
    void direct(const JointEnds&, std::size_t k) override { t_[k] = cross(a_.series(), b_.series(), k); }
    Real acceleration(std::size_t k) const override { return twice(k) * dot(a_.series(), b_.series(), k + 2); }

  private:
    Attached a_, b_;
};

}  // namespace

JointEnds::JointEnds(const Joint& joint, BodySeries& first_body, BodySeries& second_body)
    : first(first_body),
      second(second_body),
      arm_first(first, joint.r_first),
      arm_second(second, joint.r_second),
      d(vectors(first)) {}

void JointEnds::follow(std::size_t i) {
    arm_first.update(i), arm_second.update(i);
    d[i] = first.x[i] + arm_first[i] - second.x[i] - arm_second[i];
}

std::unique_ptr<PointRowSeries> point_rows(const Joint& joint, const JointEnds& ends) {
    if (joint.type->has(Primitive::coincidence)) return coincidence_rows(ends);
    if (joint.type->has(Primitive::along)) return along_rows(joint, ends);
    if (joint.type->has(Primitive::distance)) return distance_row(joint, ends);
    if (joint.type->has(Primitive::contact)) return contact_rows(joint, ends);
    return nullptr;
}

std::unique_ptr<DirectionRowSeries> direction_row(const Joint& joint, const JointRow& row, const JointEnds& ends) {
    if (row.primitive == Primitive::orthogonal) return std::make_unique<OrthogonalRow>(joint, row, ends);
    if (row.primitive == Primitive::turn) return prescribed_turn_row(joint, ends);
    if (row.primitive == Primitive::helix) return helix_row(joint, ends);
    if (row.primitive == Primitive::rack) return rack_row(joint, ends);
    if (row.primitive == Primitive::mesh) return mesh_row(joint, ends);
    return nullptr;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
