// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/force_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// With d from the first point to the second, l = |d| and s = l - length, by Horner's rule
///   h_n = c_n,   h_i = c_i + s h_{i+1},   l tension = (s h_1 + damping l') d   on the first.
class PolynomialSpringSeries final : public ForceSeries {
  public:
    PolynomialSpringSeries(const PolynomialSpring& spring, const BodyAt& at)
        : spring_(spring),
          first_(at(spring.first)),
          second_(at(spring.second)),
          arm_first_(first_, spring.r_first),
          arm_second_(second_, spring.r_second),
          d_(vectors(first_)),
          scaled_(d_),
          tension_(d_),
          square_(scalars(first_)),
          length_(square_),
          stretch_(square_),
          size_(square_),
          horner_(spring.coefficients.size(), square_) {}

    void start(const Real&) override { update(0); }

    void act(std::size_t k) override {
        update(k + 1);
        const std::size_t n = horner_.size();
        for (std::size_t i = n; i-- > 0;) {
            horner_[i][k] = i + 1 < n ? product(stretch_, horner_[i + 1], k) : Real(0);
            if (k == 0) horner_[i][k] += spring_.coefficients[i];
        }
        size_[k] = spring_.damping * rate(length_, k);
        if (n > 0) size_[k] += product(stretch_, horner_[0], k);
        scaled_[k] = product(size_, d_, k);
        tension_[k] = quotient(scaled_, length_, tension_, k);
        first_.act(tension_[k], cross(arm_first_.series(), tension_, k), k);
        second_.act(-tension_[k], -cross(arm_second_.series(), tension_, k), k);
    }

  private:
    void update(std::size_t i) {
        arm_first_.update(i), arm_second_.update(i);
        d_[i] = second_.x[i] + arm_second_[i] - first_.x[i] - arm_first_[i];
        square_[i] = dot(d_, d_, i);
        length_[i] = square_root(square_, length_, i);
        stretch_[i] = i == 0 ? Real(length_[0] - spring_.length) : length_[i];
    }

    PolynomialSpring spring_;
    BodySeries &first_, &second_;
    Attached arm_first_, arm_second_;
    Vectors d_, scaled_, tension_;
    Scalars square_, length_, stretch_, size_;
    std::vector<Scalars> horner_;
};

const SeriesRegistration<PolynomialSpring, PolynomialSpringSeries> polynomial_spring_series;

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
