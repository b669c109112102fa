// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/force_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// With d from the first point to the second and l = |d|: (stiffness (l - length) + damping l') d / l on the first.
class SpringSeries final : public ForceSeries {
  public:
    SpringSeries(const Spring& spring, const BodyAt& at)
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
          size_(square_),
          stretches_(spring.length != 0 || spring.damping != 0) {}

    void start(const Real&) override { update(0); }

    void act(std::size_t k) override {
        update(k + 1);
        tension_[k] = spring_.stiffness * d_[k];
        if (stretches_) {
            size_[k] = spring_.stiffness * length_[k] + spring_.damping * rate(length_, k);
            if (k == 0) size_[k] -= spring_.stiffness * spring_.length;
            scaled_[k] = product(size_, d_, k);
            tension_[k] = quotient(scaled_, length_, tension_, k);
        }
        first_.act(tension_[k], cross(arm_first_.series(), tension_, k), k);
        second_.act(-tension_[k], -cross(arm_second_.series(), tension_, k), k);
    }

  private:
    void update(std::size_t i) {
        arm_first_.update(i), arm_second_.update(i);
        d_[i] = second_.x[i] + arm_second_[i] - first_.x[i] - arm_first_[i];
        if (!stretches_) return;  // the points may meet
        square_[i] = dot(d_, d_, i);
        length_[i] = square_root(square_, length_, i);
    }

    Spring spring_;
    BodySeries &first_, &second_;
    Attached arm_first_, arm_second_;
    Vectors d_, scaled_, tension_;  // scaled: l' is a Cauchy product, and l tension a quotient
    Scalars square_, length_, size_;
    bool stretches_;
};

const SeriesRegistration<Spring, SpringSeries> spring_series;

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
