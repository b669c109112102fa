// SPDX-License-Identifier: BSD-3-Clause
#include "methods/rkmk/rkmk.hpp"

#include <algorithm>

#include "lie/chart.hpp"
#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// On TG = G x R^n the velocity factor is additive: there psi(u) adds and its inverse differential is the identity, so
/// the chart is needed on G only. A slope is k~ = (dpsi^{-1}_{-u}(v), v'), and u carries both parts.
template <class Chart>
class MuntheKaas final : public Integrator {
  public:
    MuntheKaas(System& system, Chart chart, const Tableau& tableau)
        : system_(system),
          chart_(std::move(chart)),
          n_(static_cast<std::size_t>(system.velocities())),
          size_(static_cast<std::size_t>(system.group().size())),
          stride_(padded(2 * n_)),
          tableau_(tableau, stride_),
          u_(stride_),
          slopes_(stride_ * tableau_.stages()),
          stage_(size_ + n_),
          weights_(tableau_.dense.size()) {}

    Status start(const Real&, const Real*) override {
        first_known_ = last_is_first_ = false;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (const Status status = stages(0, tableau_.stages_of_step, t, h, y); status != Status::ok) return status;
        combine(tableau_.b, h, slopes_.data(), stride_, u_.data());
        append(y, y);
        return Status::ok;
    }

    /// error = u - u^, both in the chart around y.
    Status attempt(const Real& t, const Real& h, const Real* y, Real* y_new, Real* error) override {
        if (last_is_first_) take_last_as_first();
        if (const Status status = stages(first_known_, tableau_.stages(), t, h, y); status != Status::ok) return status;
        first_known_ = true;  // a rejected step starts from here once more
        combine(tableau_.error, h, slopes_.data(), stride_, u_.data());
        std::copy_n(u_.data(), 2 * n_, error);
        combine(tableau_.b, h, slopes_.data(), stride_, u_.data());
        append(y, y_new);
        return Status::ok;
    }

    void accept(bool moved) override {
        first_known_ = false;
        last_is_first_ = tableau_.first_same_as_last && !moved;
    }

    /// y = y0 psi(h sum b_i(theta) k~_i): in the chart, what the weights make of any differential equation.
    void interpolate(const Real& theta, const Real& h, const Real* y0, Real* y) override {
        tableau_.weigh(theta, weights_);
        combine(weights_, h, slopes_.data(), stride_, u_.data());
        chart_.append(y0, u_.data(), y);
        for (std::size_t i = 0; i < n_; ++i) y[size_ + i] = y0[size_ + i] + u_[n_ + i];
    }

  private:
    /// The last stage lies at u of the new state. What the pull-back made of its slope (v, v') in the old chart is v'
    /// in its second half only; v is the velocity of the state. Done when the next step begins: until then the slopes
    /// are those of the dense output.
    void take_last_as_first() {
        const Real* last = slopes_.data() + (tableau_.stages() - 1) * stride_;
        std::copy_n(stage_.data() + size_, n_, slopes_.data());
        std::copy_n(last + n_, n_, slopes_.data() + n_);
        first_known_ = true, last_is_first_ = false;
    }

    /// The slopes of the stages [first, end).
    Status stages(std::size_t first, std::size_t end, const Real& t, const Real& h, const Real* y) {
        for (std::size_t i = first; i < end; ++i) {
            const Status status = stage(tableau_.a[i], t + tableau_.c[i] * h, h, y, slopes_.data() + i * stride_);
            if (status != Status::ok) return status;
        }
        return Status::ok;
    }

    /// out = y psi(u).
    void append(const Real* y, Real* out) {
        const Real* u = u_.data();
        ++work_.exponentials;
        chart_.append(y, u, out);
        y += size_, u += n_, out += size_;
        KREISEL_ELEMENTWISE
        for (std::size_t i = 0; i < n_; ++i) out[i] = y[i] + u[i];
    }

    /// The slope k~_i in the chart around y.
    Status stage(const Combination& row, const Real& t, const Real& h, const Real* y, Real* slope) {
        if (row.empty()) {  // u = 0: k~ = k
            for (std::size_t i = 0; i < n_; ++i) slope[i] = y[size_ + i];
            return system_.evaluate(t, y, y + size_, slope + n_);
        }
        combine(row, h, slopes_.data(), stride_, u_.data());
        append(y, stage_.data());
        const Real* v = stage_.data() + size_;
        const Status status = system_.evaluate(t, stage_.data(), v, slope + n_);
        if (status != Status::ok) return status;
        work_.brackets += chart_.brackets();
        return chart_.pull_back(u_.data(), v, slope) ? Status::ok : Status::left_chart;
    }

    System& system_;
    Chart chart_;
    std::size_t n_, size_, stride_;
    BoundTableau tableau_;
    std::vector<Real> u_, slopes_, stage_;
    Combination weights_;         // b_i(theta)
    bool first_known_ = false;    // the first slope is that of the state
    bool last_is_first_ = false;  // the last slope is that of the state
};

template <class Chart>
std::unique_ptr<Integrator> lift(System& system, Chart chart, const Tableau& tableau) {
    return std::make_unique<MuntheKaas<Chart>>(system, std::move(chart), tableau);
}

/// The chart given by the options; `order` is the declared one, which decides what dexpinv = "seed" means.
std::unique_ptr<Integrator> lift_with(System& system, const OptionValues& options, int order, const Tableau& tableau) {
    const Group& group = system.group();
    if (options.at("coordinates") == OptionValue("cayley")) return lift(system, CayleyChart(group), tableau);
    if (options.at("coordinates") == OptionValue("second_kind")) return lift(system, SecondKindChart(group), tableau);
    const OptionValue& dexpinv = options.at("dexpinv");
    if (const long* brackets = std::get_if<long>(&dexpinv))
        return lift(system, TruncatedExpChart(group, static_cast<int>(*brackets)), tableau);
    if (dexpinv == OptionValue("seed")) return lift(system, TruncatedExpChart(group, order - 1), tableau);
    return lift(system, ExpChart(group), tableau);
}

}  // namespace

Factory rkmk(const Tableau& tableau) {
    Factory factory;
    factory.make = [tableau](System& system, const OptionValues& options, const MethodDescription& declared) {
        return lift_with(system, options, declared.order.configuration, tableau);
    };
    factory.options = {{.name = "coordinates",
                        .summary = "local coordinates of a step",
                        .standard = "exp",
                        .choices = {"exp", "cayley", "second_kind"}},
                       {.name = "dexpinv",
                        .summary = "inverse differential of exp: in closed form, or cut after q brackets "
                                   "(seed: q = order - 1); of exp coordinates only",
                        .standard = "exact",
                        .choices = {"exact", "seed"},
                        .count_min = 0,
                        .count_max = max_brackets}};
    // dexpinv after q brackets leaves an error of the size of q + 1 of them: order min(p, q + 2)
    // [hairer2006, Thm IV.8.5].
    factory.order = [](const OptionValues& options, const Order& declared) {
        const long* brackets = std::get_if<long>(&options.at("dexpinv"));
        return brackets ? Order(std::min(declared.configuration, static_cast<int>(*brackets) + 2)) : declared;
    };
    factory.why_not = [](const OptionValues& options) -> std::string {
        const bool truncated = options.at("dexpinv") != OptionValue("exact");
        const std::string coordinates = std::get<std::string>(options.at("coordinates"));
        return truncated && coordinates != "exp" ? "dexpinv does not apply under " + coordinates + " coordinates" : "";
    };
    factory.stages = stages_of_step(tableau);
    factory.scheme = Scheme(MuntheKaasScheme{tableau});
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
