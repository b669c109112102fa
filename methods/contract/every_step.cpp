// SPDX-License-Identifier: BSD-3-Clause
#include "methods/contract/every_step.hpp"

#include <utility>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class EverySteps final : public Projection {
  public:
    EverySteps(long k, std::unique_ptr<Projection> projection) : k_(k), projection_(std::move(projection)) {}

    void start() override {
        steps_ = 0;
        projection_->start();
    }
    Status project(const Real& t, Real* y) override {
        if (++steps_ % k_ != 0) return Status::ok;
        const Status status = projection_->project(t, y);
        iterations_ = projection_->iterations();
        return status;
    }
    void retract() override {
        if (steps_-- % k_ == 0) projection_->retract();
    }

  private:
    long k_, steps_ = 0;  // steps since the start
    std::unique_ptr<Projection> projection_;
};

}  // namespace

OptionDescription every_option() {
    return {.name = "every",
            .summary = "k: after each k-th step only, of those accepted",
            .standard = 1L,
            .count_min = 1,
            .count_max = 1000000};
}

std::unique_ptr<Projection> every_steps(long k, std::unique_ptr<Projection> projection) {
    if (k == 1) return projection;
    return std::make_unique<EverySteps>(k, std::move(projection));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
