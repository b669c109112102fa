// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/projection.hpp"
#include "tests/controls/broken.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class EndProjection final : public Integrator {
  public:
    EndProjection(const Method& base, System& system)
        : step_(base.factory.make(system, with_defaults({}, base.description.options), base.description)),
          project_(projection("position_velocity").make(system, {})),
          end_(static_cast<std::size_t>(system.state_group().size())) {}

    Status start(const Real& t, const Real* y) override {
        project_->start();
        return step_->start(t, y);
    }
    Status step(const Real& t, const Real& h, Real* y) override {
        std::copy_n(y, end_.size(), end_.begin());
        Status status = step_->step(t, h, end_.data());
        if (status == Status::ok) status = project_->project(t + h, end_.data());
        if (status == Status::ok) std::copy(end_.begin(), end_.end(), y);
        return status;
    }

  private:
    std::unique_ptr<Integrator> step_;
    std::unique_ptr<Projection> project_;
    std::vector<Real> end_;
};

}  // namespace

Factory projected_at_the_end(const std::string& base) {
    Factory factory;
    factory.make = [&base = method(base)](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<EndProjection>(base, system);
    };
    factory.stages = 1;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
