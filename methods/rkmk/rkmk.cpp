// SPDX-License-Identifier: BSD-3-Clause
#include "methods/rkmk/rkmk.hpp"

#include <algorithm>

#include "lie/chart.hpp"
#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/state_space.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// On TG = G x R^n the velocity factor is additive: there psi(u) adds and its inverse differential is the identity, so
/// the chart is needed on G only. A slope is k~ = (dpsi^{-1}_{-u}(v), v'), and u carries both parts.
template <class Chart>
class TangentSpace {
  public:
    TangentSpace(System& system, Chart chart)
        : system_(system),
          chart_(std::move(chart)),
          n_(static_cast<std::size_t>(system.velocities())),
          size_(static_cast<std::size_t>(system.group().size())) {}

    /// out = y psi(u).
    void append(const Real* y, const Real* u, Real* out) {
        chart_.append(y, u, out);
        y += size_, u += n_, out += size_;
        KREISEL_ELEMENTWISE
        for (std::size_t i = 0; i < n_; ++i) out[i] = y[i] + u[i];
    }
    /// The slope k at y, which is k~ for u = 0.
    Status slope(const Real& t, const Real* y, Real* k) {
        for (std::size_t i = 0; i < n_; ++i) k[i] = y[size_ + i];
        return system_.evaluate(t, y, y + size_, k + n_);
    }
    /// The slope k~ at the stage y psi(u), in the chart around y.
    Status slope(const Real& t, const Real* stage, const Real* u, Real* k) {
        const Real* v = stage + size_;
        const Status status = system_.evaluate(t, stage, v, k + n_);
        if (status != Status::ok) return status;
        return chart_.pull_back(u, v, k) ? Status::ok : Status::left_chart;
    }
    /// k of k~ at a stage, where it is known: what the pull-back made of (v, v') is v' in its second half.
    bool recall(const Real* stage, const Real* pulled, Real* k) const {
        std::copy_n(stage + size_, n_, k);
        std::copy_n(pulled + n_, n_, k + n_);
        return true;
    }
    void to_tangent(const Real*, Real*) const {}
    int brackets() const { return chart_.brackets(); }

  private:
    System& system_;
    Chart chart_;
    std::size_t n_, size_;
};

/// Another group on states, with a chart of its own (methods/contract/state_space.hpp).
template <class Chart>
class ActedSpace {
  public:
    ActedSpace(System& system, Chart chart) : space_(system), chart_(std::move(chart)) {}

    void append(const Real* y, const Real* u, Real* out) { chart_.append(y, u, out); }
    Status slope(const Real& t, const Real* y, Real* k) { return space_.slope(t, y, k); }
    Status slope(const Real& t, const Real* stage, const Real* u, Real* k) {
        const Status status = space_.slope(t, stage, k);
        if (status != Status::ok) return status;
        return chart_.pull_back(u, k, k) ? Status::ok : Status::left_chart;
    }
    bool recall(const Real*, const Real*, Real*) const { return false; }
    void to_tangent(const Real* y, Real* error) const { space_.to_tangent(y, error); }
    int brackets() const { return chart_.brackets(); }

  private:
    StateSpace space_;
    Chart chart_;
};

template <class Space>
class MuntheKaas final : public Integrator {
  public:
    MuntheKaas(const TangentGroup& states, Space space, const Tableau& tableau)
        : space_(std::move(space)),
          dim_(static_cast<std::size_t>(states.dim())),
          stride_(padded(dim_)),
          tableau_(tableau, stride_),
          u_(stride_),
          slopes_(stride_ * tableau_.stages()),
          stage_(static_cast<std::size_t>(states.size())),
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
        std::copy_n(u_.data(), dim_, error);
        space_.to_tangent(y, error);
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
        space_.append(y0, u_.data(), y);
    }

  private:
    /// The last stage lies at u of the new state. Done when the next step begins: until then the slopes are those of
    /// the dense output.
    void take_last_as_first() {
        first_known_ = space_.recall(stage_.data(), slopes_.data() + (tableau_.stages() - 1) * stride_, slopes_.data());
        last_is_first_ = false;
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
        ++work_.exponentials;
        space_.append(y, u_.data(), out);
    }

    /// The slope k~_i in the chart around y.
    Status stage(const Combination& row, const Real& t, const Real& h, const Real* y, Real* slope) {
        if (row.empty()) return space_.slope(t, y, slope);
        combine(row, h, slopes_.data(), stride_, u_.data());
        append(y, stage_.data());
        work_.brackets += space_.brackets();
        return space_.slope(t, stage_.data(), u_.data(), slope);
    }

    Space space_;
    std::size_t dim_, stride_;
    BoundTableau tableau_;
    std::vector<Real> u_, slopes_, stage_;
    Combination weights_;         // b_i(theta)
    bool first_known_ = false;    // the first slope is that of the state
    bool last_is_first_ = false;  // the last slope is that of the state
};

/// `arguments` are those of the chart behind its group.
template <class Chart, class... Arguments>
std::unique_ptr<Integrator> lift(System& system, const Tableau& tableau, Arguments... arguments) {
    const TangentGroup& states = system.state_group();
    const StateSpace space(system);
    if (space.is_tangent_group()) {
        TangentSpace<Chart> tangent(system, Chart(system.group(), arguments...));
        return std::make_unique<MuntheKaas<TangentSpace<Chart>>>(states, std::move(tangent), tableau);
    }
    ActedSpace<Chart> acted(system, Chart(space.group(), arguments...));
    return std::make_unique<MuntheKaas<ActedSpace<Chart>>>(states, std::move(acted), tableau);
}

/// The chart given by the options; `order` is the declared one, which decides what dexpinv = "seed" means.
std::unique_ptr<Integrator> lift_with(System& system, const OptionValues& options, int order, const Tableau& tableau) {
    if (options.at("coordinates") == OptionValue("cayley")) return lift<CayleyChart>(system, tableau);
    if (options.at("coordinates") == OptionValue("second_kind")) return lift<SecondKindChart>(system, tableau);
    const OptionValue& dexpinv = options.at("dexpinv");
    if (const long* brackets = std::get_if<long>(&dexpinv))
        return lift<TruncatedExpChart>(system, tableau, static_cast<int>(*brackets));
    if (dexpinv == OptionValue("seed")) return lift<TruncatedExpChart>(system, tableau, order - 1);
    return lift<ExpChart>(system, tableau);
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
    factory.takes_actions = true;
    factory.scheme = Scheme(MuntheKaasScheme{tableau});
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
