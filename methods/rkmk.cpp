// SPDX-License-Identifier: BSD-3-Clause
#include "methods/rkmk.hpp"

#include "lie/chart.hpp"
#include "mechanics/system.hpp"
#include "methods/bound_tableau.hpp"
#include "methods/integrator.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class MuntheKaas final : public Integrator {
  public:
    MuntheKaas(System& system, std::unique_ptr<Chart> chart, const BoundTableau& tableau)
        : system_(system),
          chart_(std::move(chart)),
          tableau_(tableau),
          dim_(system.state_group().dim()),
          u_(static_cast<std::size_t>(dim_)),
          k_(u_.size()),
          slopes_(u_.size() * static_cast<std::size_t>(tableau.stages())),
          stage_(static_cast<std::size_t>(system.state_group().size())) {}

    Status step(const Real& t, const Real& h, Real* y) override {
        for (int i = 0; i < tableau_.stages(); ++i)
            if (const Status status = stage(i, t, h, y); status != Status::ok) return status;
        combine(tableau_.b, h, slopes_.data(), dim_, u_.data());
        chart_->append(y, u_.data(), y);
        return Status::ok;
    }

  private:
    /// The slope k~_i in the chart around y.
    Status stage(int i, const Real& t, const Real& h, const Real* y) {
        const auto index = static_cast<std::size_t>(i);
        Real* slope = &slopes_[index * u_.size()];
        const Combination& row = tableau_.a[index];
        if (row.empty()) return system_.vector_field(t + tableau_.c[index] * h, y, slope);  // u = 0: k~ = k
        combine(row, h, slopes_.data(), dim_, u_.data());
        chart_->append(y, u_.data(), stage_.data());
        const Status status = system_.vector_field(t + tableau_.c[index] * h, stage_.data(), k_.data());
        if (status != Status::ok) return status;
        return chart_->pull_back(u_.data(), k_.data(), slope) ? Status::ok : Status::left_chart;
    }

    System& system_;
    std::unique_ptr<Chart> chart_;
    BoundTableau tableau_;
    int dim_;
    std::vector<Real> u_, k_, slopes_, stage_;
};

std::unique_ptr<Chart> make_chart(const Group& group, const OptionValues& options, int order) {
    if (std::get<std::string>(options.at("coordinates")) == "cayley") return cayley_chart(group);
    const OptionValue& dexpinv = options.at("dexpinv");
    if (const long* brackets = std::get_if<long>(&dexpinv)) return truncated_exp_chart(group, static_cast<int>(*brackets));
    if (std::get<std::string>(dexpinv) == "seed") return truncated_exp_chart(group, order - 1);
    return exp_chart(group);
}

}  // namespace

Factory rkmk(const Tableau& tableau) {
    Factory factory;
    factory.make = [tableau](System& system, const OptionValues& options, const MethodDescription& declared) {
        auto chart = make_chart(system.state_group(), options, declared.order.configuration);
        return std::make_unique<MuntheKaas>(system, std::move(chart), BoundTableau(tableau));
    };
    factory.options = {{.name = "coordinates", .summary = "local coordinates of a step", .standard = "exp", .choices = {"exp", "cayley"}},
                       {.name = "dexpinv",
                        .summary = "inverse differential of exp: in closed form, or cut after q brackets "
                                   "(seed: q = order - 1); does not apply under cayley",
                        .standard = "exact",
                        .choices = {"exact", "seed"},
                        .count_min = 0,
                        .count_max = max_brackets}};
    factory.why_not = [](const OptionValues& options) -> std::string {
        const bool truncated = options.at("dexpinv") != OptionValue("exact");
        const bool cayley = options.at("coordinates") == OptionValue("cayley");
        return truncated && cayley ? "dexpinv does not apply under cayley coordinates" : "";
    };
    factory.stages = static_cast<int>(tableau.b.size());
    factory.scheme = Scheme{Scheme::Kind::munthe_kaas, tableau};
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
