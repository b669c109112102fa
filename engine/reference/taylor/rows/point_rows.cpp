// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/rows/point_rows.hpp"

#include "engine/reference/taylor/rows/prescribed_series.hpp"
#include "engine/reference/taylor/rows/scalars.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// d = 0.
class CoincidenceRow final : public PointRowSeries {
  public:
    explicit CoincidenceRow(const JointEnds& ends) : PointRowSeries(ends) {
        for (int k = 0; k < 3; ++k) {
            n_.push_back(vectors(ends.first));
            n_.back()[0] = Vec3::Unit(k);
        }
    }
    void follow(const JointEnds& ends, std::size_t i) override { lever_[i] = ends.arm_second[i]; }
    Real acceleration(const JointEnds& ends, int row, std::size_t k) const override {
        return twice(k) * n(row)[0].dot(ends.d[k + 2]);
    }
};

/// b . d = 0 for axes b of the second body, b_3 . d + f = 0 for a prescribed shift. The force acts at the point of the
/// first.
class AlongRow final : public PointRowSeries {
  public:
    AlongRow(const Joint& joint, const JointEnds& ends)
        : PointRowSeries(ends), law_(joint.shift), shift_(scalars(ends)) {
        for (const JointRow& row : joint.type->rows) {
            const bool shifted = row.primitive == Primitive::shift;
            if (!shifted && row.primitive != Primitive::along) continue;
            axes_.emplace_back(joint.axes_second.col(shifted ? 2 : row.k));
            shifted_.push_back(shifted);
            n_.push_back(vectors(ends.first));
        }
    }
    bool turns() const override { return true; }
    void start(const Real& t) override { expand(law_, t, shift_); }
    void follow(const JointEnds& ends, std::size_t i) override {
        lever_[i] = ends.arm_second[i];
        lever_[i] += ends.d[i];
        for (std::size_t r = 0; r < axes_.size(); ++r) n_[r][i] = ends.second.R[i] * axes_[r];
    }
    Real acceleration(const JointEnds& ends, int row, std::size_t k) const override {
        const Real across = dot(n(row), ends.d, k + 2);
        return twice(k) * (shifted_[static_cast<std::size_t>(row)] ? Real(across + shift_[k + 2]) : across);
    }

  private:
    Prescribed law_;
    Scalars shift_;
    Vectors axes_;
    std::vector<bool> shifted_;
};

/// |d| = L(t), n = d / |d|.
class DistanceRow final : public PointRowSeries {
  public:
    DistanceRow(const Joint& joint, const JointEnds& ends)
        : PointRowSeries(ends), joint_(joint), square_(scalars(ends)), length_(square_), law_(square_) {
        n_.push_back(vectors(ends.first));
    }
    bool turns() const override { return true; }
    void start(const Real& t) override {
        modulate(joint_.amplitude, joint_.frequency, t, law_);
        for (Real& coefficient : law_) coefficient *= joint_.length;
    }
    void follow(const JointEnds& ends, std::size_t i) override {
        lever_[i] = ends.arm_second[i];
        square_[i] = dot(ends.d, ends.d, i);
        length_[i] = square_root(square_, length_, i);
    }
    void direct(const JointEnds& ends, std::size_t k) override { n_[0][k] = quotient(ends.d, length_, n_[0], k); }
    Real acceleration(const JointEnds&, int, std::size_t k) const override {
        return twice(k) * (length_[k + 2] - law_[k + 2]);
    }

  private:
    Joint joint_;
    Scalars square_, length_, law_;  // |d|^2, |d|, L
};

}  // namespace

std::unique_ptr<PointRowSeries> coincidence_rows(const JointEnds& ends) {
    return std::make_unique<CoincidenceRow>(ends);
}

std::unique_ptr<PointRowSeries> along_rows(const Joint& joint, const JointEnds& ends) {
    return std::make_unique<AlongRow>(joint, ends);
}

std::unique_ptr<PointRowSeries> distance_row(const Joint& joint, const JointEnds& ends) {
    return std::make_unique<DistanceRow>(joint, ends);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
