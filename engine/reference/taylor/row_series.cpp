// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/row_series.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Scalars scalars(const JointEnds& ends) { return Scalars(ends.d.size(), Real(0)); }
Real twice(std::size_t k) { return real(k + 1) * real(k + 2); }

/// f(t + s) as a series in s.
void expand(const Prescribed& law, const Real& t, Scalars& series) {
    std::fill(series.begin(), series.end(), Real(0));
    std::vector<Real> rest = law.polynomial;  // divided by (x - t) again and again: what remains are the coefficients
    for (std::size_t k = 0; k < rest.size() && k < series.size(); ++k) {
        for (std::size_t j = rest.size() - 1; j-- > k;) rest[j] += t * rest[j + 1];
        series[k] = rest[k];
    }
    for (const auto& [amplitude, frequency, phase] : law.sinusoids) {
        const Real angle = frequency * t + phase, derivatives[] = {sin(angle), cos(angle), -sin(angle), -cos(angle)};
        Real factor = amplitude;
        for (std::size_t k = 0; k < series.size(); factor *= frequency / real(++k))
            series[k] += factor * derivatives[k % 4];
    }
}

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

/// A disk of axis b on the plane of normal n: s = n - (n . b) b leads away from the contact, which is L s/|s| below the
/// centre. One row on its height, two on the velocity of the point in contact.
class ContactRow final : public PointRowSeries {
  public:
    ContactRow(const Joint& joint, const JointEnds& ends)
        : PointRowSeries(ends),
          radius_(joint.length),
          axis_(ends.second, joint.axes_second.col(2)),
          cosine_(scalars(ends)),
          square_(cosine_),
          length_(cosine_),
          s_(ends.d),
          unit_(s_),
          omega_(s_) {
        for (const int k : {2, 0, 1}) {
            n_.push_back(vectors(ends.first));
            n_.back()[0] = joint.axes_first.col(k);
        }
    }
    bool is_velocity(int row) const override { return row > 0; }
    /// Here s has the opposite sign; omega stands one coefficient below R.
    void follow(const JointEnds& ends, std::size_t i) override {
        lever_[i] = ends.arm_second[i];
        const Vec3& normal = n_[0][0];
        axis_.update(i);
        cosine_[i] = normal.dot(axis_[i]);
        s_[i] = product(cosine_, axis_.series(), i);
        if (i == 0) s_[i] -= normal;
        square_[i] = dot(s_, s_, i);
        length_[i] = square_root(square_, length_, i);
        unit_[i] = quotient(s_, length_, unit_, i);
        lever_[i] += radius_ * unit_[i];
        if (i > 0) omega_[i - 1] = product(ends.second.R, ends.second.omega, i - 1);
    }
    Real acceleration(const JointEnds& ends, int row, std::size_t k) const override {
        const BodySeries& disk = ends.second;
        if (!is_velocity(row)) return -twice(k) * n(row)[0].dot(disk.x[k + 2] + lever_[k + 2]);
        return -real(k + 1) * n(row)[0].dot(rate(disk.x, k + 1) + cross(omega_, lever_, k + 1));
    }

  private:
    Real radius_;
    Attached axis_;
    Scalars cosine_, square_, length_;  // n . b, |s|^2, |s|
    Vectors s_, unit_, omega_;          // -s, -s/|s|, and omega in space axes
};

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

/// tan = (a . b_2) / (a . b_1) of an axis a that has turned by f in the first body, a = cos f a1 + sin f a2: where it
/// vanishes its gradient is that of the angle.
class TurnedRow : public DirectionRowSeries {
  public:
    TurnedRow(const Joint& joint, const Vec3& a1, const Vec3& a2, const JointEnds& ends)
        : DirectionRowSeries(ends),
          f_(scalars(ends)),
          a1_(ends.first, a1),
          a2_(ends.first, a2),
          b1_(ends.second, joint.axes_second.col(0)),
          b2_(ends.second, joint.axes_second.col(1)),
          cosine_(f_),
          sine_(f_),
          above_(f_),
          below_(f_),
          tangent_(f_),
          growth_(f_),
          slope_(f_),
          a_(ends.d),
          normal_(a_),
          couple_(a_) {}
    void follow(const JointEnds&, std::size_t i) override {
        a1_.update(i), a2_.update(i), b1_.update(i), b2_.update(i);
        turn(i);
        a_[i] = product(cosine_, a1_.series(), i) + product(sine_, a2_.series(), i);
        above_[i] = dot(a_, b2_.series(), i), below_[i] = dot(a_, b1_.series(), i);
        tangent_[i] = quotient(above_, below_, tangent_, i);
    }
    void direct(const JointEnds&, std::size_t k) override {
        normal_[k] = cross(a_, b2_.series(), k);
        t_[k] = couple_[k] = quotient(normal_, below_, couple_, k);
    }
    Real acceleration(std::size_t k) const override { return twice(k) * tangent_[k + 2]; }

  protected:
    Scalars f_;
    /// Coefficient k of the derivative of the residual in f, after those before it.
    Real slope(std::size_t k) {
        Real sum = 0;
        for (std::size_t j = 0; j <= k; ++j)
            sum += (product(cosine_, a2_.series(), j) - product(sine_, a1_.series(), j)).dot(b2_[k - j]);
        growth_[k] = sum;
        return slope_[k] = quotient(growth_, below_, slope_, k);
    }

  private:
    /// cos' = -sin f', sin' = cos f'.
    void turn(std::size_t i) {
        if (i == 0) {
            cosine_[0] = cos(f_[0]), sine_[0] = sin(f_[0]);
            return;
        }
        Real c = 0, s = 0;
        for (std::size_t j = 1; j <= i; ++j) {
            const Real rate = real(j) * f_[j];
            c -= rate * sine_[i - j], s += rate * cosine_[i - j];
        }
        cosine_[i] = c / real(i), sine_[i] = s / real(i);
    }

    Attached a1_, a2_, b1_, b2_;
    Scalars cosine_, sine_, above_, below_, tangent_, growth_, slope_;
    Vectors a_, normal_, couple_;
};

class PrescribedTurnRow final : public TurnedRow {
  public:
    PrescribedTurnRow(const Joint& joint, const JointEnds& ends)
        : TurnedRow(joint, joint.axes_first.col(0), joint.axes_first.col(1), ends), law_(joint.turn) {}
    void start(const Real& t) override { expand(law_, t, f_); }

  private:
    Prescribed law_;
};

/// f = -2 pi b_3 . d / lead.
class HelixRow final : public TurnedRow {
  public:
    HelixRow(const Joint& joint, const JointEnds& ends)
        : TurnedRow(joint, joint.axes_first.col(0), joint.axes_first.col(1), ends),
          radians_(-2 * pi() / joint.lead),
          axis_(ends.second, joint.axes_second.col(2)),
          push_(scalars(ends)),
          n_(ends.d) {}
    const Vectors* n() const override { return &n_; }
    void follow(const JointEnds& ends, std::size_t i) override {
        axis_.update(i);
        f_[i] = radians_ * dot(axis_.series(), ends.d, i);
        TurnedRow::follow(ends, i);
    }
    void direct(const JointEnds& ends, std::size_t k) override {
        TurnedRow::direct(ends, k);
        push_[k] = radians_ * slope(k);
        n_[k] = product(push_, axis_.series(), k);
    }

  private:
    Real radians_;  // for each metre of b_3 . d
    Attached axis_;
    Scalars push_;
    Vectors n_;
};

/// f = 2 pi a_3 . d / lead, a_1(f) in the plane of a_3 and -a_2. Since a_3 turns with the first body, so does the
/// gradient: there is a moment a_3 x d.
class RackRow final : public TurnedRow {
  public:
    RackRow(const Joint& joint, const JointEnds& ends)
        : TurnedRow(joint, joint.axes_first.col(2), -joint.axes_first.col(1), ends),
          radians_(2 * pi() / joint.lead),
          axis_(ends.first, joint.axes_first.col(2)),
          push_(scalars(ends)),
          n_(ends.d) {}
    const Vectors* n() const override { return &n_; }
    void follow(const JointEnds& ends, std::size_t i) override {
        axis_.update(i);
        f_[i] = radians_ * dot(axis_.series(), ends.d, i);
        TurnedRow::follow(ends, i);
    }
    void direct(const JointEnds& ends, std::size_t k) override {
        TurnedRow::direct(ends, k);
        push_[k] = radians_ * slope(k);
        n_[k] = product(push_, axis_.series(), k);
        t_[k] += cross(n_, ends.d, k);
    }

  private:
    Real radians_;  // for each metre of a_3 . d
    Attached axis_;
    Scalars push_;
    Vectors n_;
};

/// The angle psi of d in the axes (e_1, e_2) of a body: psi' = (C S' - S C') / (C^2 + S^2), C = e_1 . d, S = e_2 . d.
class LineAngle {
  public:
    LineAngle(const BodySeries& body, const Mat3& axes, const JointEnds& ends)
        : e1_(body, axes.col(0)),
          e2_(body, axes.col(1)),
          C_(scalars(ends)),
          S_(C_),
          square_(C_),
          area_(C_),
          rate_(C_),
          cosine_(C_),
          sine_(C_) {}
    void follow(const JointEnds& ends, std::size_t i) {
        e1_.update(i), e2_.update(i);
        C_[i] = dot(e1_.series(), ends.d, i), S_[i] = dot(e2_.series(), ends.d, i);
        square_[i] = product(C_, C_, i) + product(S_, S_, i);
        if (i == 0) return;
        Real area = 0;
        for (std::size_t j = 0; j < i; ++j) area += C_[j] * rate(S_, i - 1 - j) - S_[j] * rate(C_, i - 1 - j);
        area_[i - 1] = area;
        rate_[i - 1] = quotient(area_, square_, rate_, i - 1);
    }
    /// Coefficient k of psi''.
    Real second(std::size_t k) const { return rate(rate_, k); }
    /// Coefficient k of the gradient in d.
    Vec3 gradient(std::size_t k) {
        cosine_[k] = quotient(C_, square_, cosine_, k), sine_[k] = quotient(S_, square_, sine_, k);
        return product(cosine_, e2_.series(), k) - product(sine_, e1_.series(), k);
    }

  private:
    Attached e1_, e2_;
    Scalars C_, S_, square_, area_, rate_, cosine_, sine_;
};

/// (z_1 psi_1 + z_2 psi_2) / z_2, up to a constant.
class MeshRow final : public DirectionRowSeries {
  public:
    MeshRow(const Joint& joint, const JointEnds& ends)
        : DirectionRowSeries(ends),
          ratio_(Real(joint.teeth[0]) / joint.teeth[1]),
          first_(ends.first, joint.axes_first, ends),
          second_(ends.second, joint.axes_second, ends),
          of_first_(ends.d),
          n_(ends.d) {}
    const Vectors* n() const override { return &n_; }
    void follow(const JointEnds& ends, std::size_t i) override { first_.follow(ends, i), second_.follow(ends, i); }
    /// Axes of the first body turn with it.
    void direct(const JointEnds& ends, std::size_t k) override {
        of_first_[k] = ratio_ * first_.gradient(k);
        n_[k] = of_first_[k] + second_.gradient(k);
        t_[k] = cross(of_first_, ends.d, k);
    }
    Real acceleration(std::size_t k) const override { return ratio_ * first_.second(k) + second_.second(k); }

  private:
    Real ratio_;
    LineAngle first_, second_;
    Vectors of_first_, n_;
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
    if (joint.type->has(Primitive::coincidence)) return std::make_unique<CoincidenceRow>(ends);
    if (joint.type->has(Primitive::along)) return std::make_unique<AlongRow>(joint, ends);
    if (joint.type->has(Primitive::distance)) return std::make_unique<DistanceRow>(joint, ends);
    if (joint.type->has(Primitive::contact)) return std::make_unique<ContactRow>(joint, ends);
    return nullptr;
}

std::unique_ptr<DirectionRowSeries> direction_row(const Joint& joint, const JointRow& row, const JointEnds& ends) {
    if (row.primitive == Primitive::orthogonal) return std::make_unique<OrthogonalRow>(joint, row, ends);
    if (row.primitive == Primitive::turn) return std::make_unique<PrescribedTurnRow>(joint, ends);
    if (row.primitive == Primitive::helix) return std::make_unique<HelixRow>(joint, ends);
    if (row.primitive == Primitive::rack) return std::make_unique<RackRow>(joint, ends);
    if (row.primitive == Primitive::mesh) return std::make_unique<MeshRow>(joint, ends);
    return nullptr;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
