// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/point_pair.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// With d from the first point to the second and l = |d|: (stiffness (l - length) + damping l') d / l on the first.
class SpringSeries final : public ForceSeries {
  public:
    SpringSeries(const Spring& spring, const BodyAt& at)
        : spring_(spring),
          points_(spring, at),
          scaled_(points_.vectors()),
          tension_(scaled_),
          size_(points_.scalars()),
          stretches_(spring.length != 0 || spring.damping != 0) {}

    void start(const Real&) override { update(0); }

    void act(std::size_t k) override {
        update(k + 1);
        tension_[k] = spring_.stiffness * points_.d()[k];
        if (stretches_) {
            size_[k] = spring_.stiffness * points_.length()[k] + spring_.damping * rate(points_.length(), k);
            if (k == 0) size_[k] -= spring_.stiffness * spring_.length;
            scaled_[k] = product(size_, points_.d(), k);
            tension_[k] = quotient(scaled_, points_.length(), tension_, k);
        }
        points_.pull(tension_, k);
    }

  private:
    void update(std::size_t i) {
        points_.update(i);
        if (stretches_) points_.measure(i);  // else the points may meet
    }

    Spring spring_;
    PointPair points_;
    Vectors scaled_, tension_;  // scaled: l' is a Cauchy product, and l tension a quotient
    Scalars size_;
    bool stretches_;
};

const SeriesRegistration<Spring, SpringSeries> spring_series;

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
