// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/point_pair.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// With d from the first point to the second, l = |d| and s = l - length, by Horner's rule
///   h_n = c_n,   h_i = c_i + s h_{i+1},   l tension = (s h_1 + damping l') d   on the first.
class PolynomialSpringSeries final : public ForceSeries {
  public:
    PolynomialSpringSeries(const PolynomialSpring& spring, const BodyAt& at)
        : spring_(spring),
          points_(spring, at),
          scaled_(points_.vectors()),
          tension_(scaled_),
          stretch_(points_.scalars()),
          size_(stretch_),
          horner_(spring.coefficients.size(), stretch_) {}

    void start(const Real&) override { update(0); }

    void act(std::size_t k) override {
        update(k + 1);
        const std::size_t n = horner_.size();
        for (std::size_t i = n; i-- > 0;) {
            horner_[i][k] = i + 1 < n ? product(stretch_, horner_[i + 1], k) : Real(0);
            if (k == 0) horner_[i][k] += spring_.coefficients[i];
        }
        size_[k] = spring_.damping * rate(points_.length(), k);
        if (n > 0) size_[k] += product(stretch_, horner_[0], k);
        scaled_[k] = product(size_, points_.d(), k);
        tension_[k] = quotient(scaled_, points_.length(), tension_, k);
        points_.pull(tension_, k);
    }

  private:
    void update(std::size_t i) {
        points_.update(i), points_.measure(i);
        stretch_[i] = i == 0 ? Real(points_.length()[0] - spring_.length) : points_.length()[i];
    }

    PolynomialSpring spring_;
    PointPair points_;
    Vectors scaled_, tension_;
    Scalars stretch_, size_;
    std::vector<Scalars> horner_;
};

const SeriesRegistration<PolynomialSpring, PolynomialSpringSeries> polynomial_spring_series;

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
