// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/rkmk/rkmk.hpp"
#include "tests/controls/broken.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class BrokenPair final : public Integrator {
  public:
    BrokenPair(System& system, std::unique_ptr<Integrator> method, PairFault fault)
        : error_size_(system.state_group().dim()), method_(std::move(method)), fault_(fault) {}

    Status start(const Real& t, const Real* y) override { return method_->start(t, y); }
    Status step(const Real& t, const Real& h, Real* y) override { return method_->step(t, h, y); }
    Status attempt(const Real& t, const Real& h, const Real* y, Real* y_new, Real* error) override {
        const Status status = method_->attempt(t, h, y, y_new, error);
        if (fault_.doubled_error) std::for_each(error, error + error_size_, [](Real& e) { e *= 2; });
        if (fault_.keeps_rejected) method_->accept(false);
        return status;
    }
    void accept(bool moved) override {
        if (!fault_.keeps_rejected) method_->accept(moved && !fault_.ignores_projection);
    }
    const Real* multipliers() const override { return method_->multipliers(); }
    const Work& work() const override { return method_->work(); }

  private:
    int error_size_;
    std::unique_ptr<Integrator> method_;
    PairFault fault_;
};

/// The pair of Bogacki and Shampine, orders 3 and 2; first same as last.
Tableau three_two() {
    return {.a = {{}, {{1, 2}}, {0, {3, 4}}, {{2, 9}, {1, 3}, {4, 9}}},
            .b = {{2, 9}, {1, 3}, {4, 9}, 0},
            .b_hat = {{7, 24}, {1, 4}, {1, 3}, {1, 8}}};
}

}  // namespace

Method broken_pair(const std::string& name, PairFault fault) {
    Factory factory = rkmk(three_two());
    factory.make = [inner = factory, fault](System& system, const OptionValues&, const MethodDescription& declared) {
        return std::make_unique<BrokenPair>(system, inner.make(system, with_defaults({}, inner.options), declared),
                                            fault);
    };
    factory.options.clear();
    return {.description = {.name = name, .order = 3, .cites = {}, .stages = factory.stages, .estimate = 3},
            .factory = std::move(factory),
            .file = __FILE__};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
