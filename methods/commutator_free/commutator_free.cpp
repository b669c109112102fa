// SPDX-License-Identifier: BSD-3-Clause
#include "methods/commutator_free/commutator_free.hpp"

#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/commutator_free/bound_products.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/state_space.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class CommutatorFree final : public Integrator {
  public:
    CommutatorFree(System& system, const CommutatorFreeScheme& scheme)
        : space_(system),
          group_(space_.group()),
          size_(static_cast<std::size_t>(group_.size())),
          stride_(padded(static_cast<std::size_t>(std::max(1, group_.dim())))),  // of a model without bodies too
          scheme_(scheme, stride_),
          stages_of_step_(static_cast<std::size_t>(stages_of_step(scheme))),
          u_(stride_),
          slopes_(stride_ * scheme_.stages.size()),
          points_(size_ * scheme_.stages.size()),
          embedded_(size_) {}

    Status start(const Real&, const Real*) override {
        first_known_ = false;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        first_known_ = false;
        if (const Status status = stages(stages_of_step_, t, h, y); status != Status::ok) return status;
        form(scheme_.result, h, y);
        return Status::ok;
    }

    Status attempt(const Real& t, const Real& h, const Real* y, Real* y_new, Real* error) override {
        if (const Status status = stages(scheme_.stages.size(), t, h, y); status != Status::ok) return status;
        first_known_ = true;  // a rejected step starts from here once more
        form(scheme_.result, h, y_new);
        form(scheme_.embedded, h, embedded_.data());
        group_.inverse(embedded_.data(), embedded_.data());
        group_.multiply(embedded_.data(), y_new, embedded_.data());
        group_.log(embedded_.data(), error);
        space_.to_tangent(y_new, error);
        return Status::ok;
    }

    void accept(bool) override { first_known_ = false; }

  private:
    Real* point(std::size_t stage) { return points_.data() + stage * size_; }
    Real* slope(std::size_t stage) { return slopes_.data() + stage * stride_; }

    /// Points and slopes of the stages before `end`.
    Status stages(std::size_t end, const Real& t, const Real& h, const Real* y) {
        std::copy_n(y, size_, point(0));
        for (std::size_t i = 0; i < end; ++i) {
            if (i == 0 && first_known_) continue;
            if (i > 0) form(scheme_.stages[i], h, point(i));
            const Status status = space_.slope(t + scheme_.c[i] * h, point(i), slope(i));
            if (status != Status::ok) return status;
        }
        return Status::ok;
    }

    /// out = y_from exp(h sum_j f_1j K_j) exp(h sum_j f_2j K_j) ...
    void form(const BoundProduct& product, const Real& h, Real* out) {
        const Real* from = point(product.from);
        for (const Combination& factor : product.factors) {
            combine(factor, h, slopes_.data(), stride_, u_.data());
            group_.append_exp(from, u_.data(), out);
            ++work_.exponentials;
            from = out;
        }
        if (product.factors.empty()) std::copy_n(from, size_, out);
    }

    StateSpace space_;
    const Group& group_;
    std::size_t size_, stride_;
    BoundProducts scheme_;
    std::size_t stages_of_step_;
    std::vector<Real> u_, slopes_, points_, embedded_;
    bool first_known_ = false;  // the first slope is that of the state
};

}  // namespace

Factory commutator_free(const CommutatorFreeScheme& scheme) {
    Factory factory;
    factory.make = [scheme](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<CommutatorFree>(system, scheme);
    };
    factory.stages = stages_of_step(scheme);
    factory.takes_actions = true;
    factory.scheme = Scheme(scheme);
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
