// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "tests/controls/broken.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class UnconvergedMidpoint final : public Integrator {
  public:
    explicit UnconvergedMidpoint(System& system)
        : system_(system),
          n_(static_cast<std::size_t>(system.velocities())),
          size_(static_cast<std::size_t>(system.group().size())) {}

    Status step(const Real& t, const Real& h, Real* y) override {
        std::vector<Real> f(n_), V(n_), u(n_), middle(size_);
        Real* v = y + size_;
        if (const Status status = system_.evaluate(t, y, v, f.data()); status != Status::ok) return status;
        for (int iteration = 0; iteration < 2; ++iteration) {
            for (std::size_t i = 0; i < n_; ++i) {
                V[i] = v[i] + h * f[i] / 2;
                u[i] = h * V[i] / 2;
            }
            system_.group().append_exp(y, u.data(), middle.data());
            const Status status = system_.evaluate(t + h / 2, middle.data(), V.data(), f.data());
            if (status != Status::ok) return status;
        }
        for (std::size_t i = 0; i < n_; ++i) {
            u[i] = h * (v[i] + h * f[i] / 2);
            v[i] += h * f[i];
        }
        system_.group().append_exp(y, u.data(), y);
        return Status::ok;
    }

  private:
    System& system_;
    std::size_t n_, size_;
};

}  // namespace

Factory unconverged_midpoint() {
    Factory factory;
    factory.make = [](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<UnconvergedMidpoint>(system);
    };
    factory.stages = 1;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
