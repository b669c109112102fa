// SPDX-License-Identifier: BSD-3-Clause
#include "methods/rkmk/implicit_rkmk.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "methods/contract/integrator.hpp"
#include "methods/implicit/stages/implicit_stages.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class ImplicitRungeKutta final : public Integrator {
  public:
    explicit ImplicitRungeKutta(std::unique_ptr<ImplicitStages> stages) : stages_(std::move(stages)) {}

    Status start(const Real&, const Real*) override {
        stages_->forget();
        return Status::ok;
    }
    Status step(const Real& t, const Real& h, Real* y) override {
        const Status status = stages_->advance(t, h, y);
        work_.newton_iterations = stages_->iterations();
        return status;
    }

  private:
    std::unique_ptr<ImplicitStages> stages_;
};

void require_tableau(bool met, const std::string& what) {
    if (!met) throw std::invalid_argument("implicit tableau: " + what);
}

VecX numbers_of(const std::vector<Coefficient>& row, std::size_t stages, const char* what) {
    require_tableau(row.size() == stages, "expected " + std::to_string(stages) + " entries of " + what + ", got " +
                                              std::to_string(row.size()));
    VecX numbers(static_cast<Eigen::Index>(stages));
    for (std::size_t j = 0; j < stages; ++j) numbers[static_cast<Eigen::Index>(j)] = value(row[j]);
    return numbers;
}

MatX rows_of(const std::vector<std::vector<Coefficient>>& rows, std::size_t stages, const char* what) {
    require_tableau(rows.size() == stages,
                    "expected " + std::to_string(stages) + " rows of " + what + ", got " + std::to_string(rows.size()));
    const auto s = static_cast<Eigen::Index>(stages);
    MatX numbers(s, s);
    for (Eigen::Index i = 0; i < s; ++i)
        numbers.row(i) = numbers_of(rows[static_cast<std::size_t>(i)], stages, what).transpose();
    return numbers;
}

StageCoefficients coefficients_of(const ImplicitTableau& tableau) {
    const std::size_t stages = tableau.b.size();
    StageCoefficients made{
        rows_of(tableau.a, stages, "a"), {}, numbers_of(tableau.b, stages, "b"), numbers_of(tableau.c, stages, "c")};
    made.a_hat = tableau.a_hat.empty() ? made.a : rows_of(tableau.a_hat, stages, "a^");
    require_tableau(abs(made.b.sum() - 1) <= 64 * epsilon, "the weights b do not sum to 1");
    for (Eigen::Index i = 0; i < made.c.size(); ++i)
        require_tableau(abs(made.a.row(i).sum() - made.c[i]) <= 64 * epsilon,
                        "node " + std::to_string(i + 1) + " is not the sum of its row");
    return made;
}

}  // namespace

std::unique_ptr<Integrator> implicit_runge_kutta(System& system, const StageCoefficients& coefficients,
                                                 bool around_middle) {
    const StageCentre centre = around_middle ? StageCentre::middle : StageCentre::start;
    return std::make_unique<ImplicitRungeKutta>(implicit_stages(system, coefficients, centre));
}

Factory implicit_rkmk(const ImplicitTableau& tableau) {
    return implicit_rkmk(
        static_cast<int>(tableau.b.size()), [tableau] { return coefficients_of(tableau); }, tableau.around_middle);
}

Factory implicit_rkmk(int stages, const std::function<StageCoefficients()>& coefficients, bool around_middle) {
    Factory factory;
    factory.make = [coefficients, around_middle](System& system, const OptionValues&, const MethodDescription&) {
        return implicit_runge_kutta(system, coefficients(), around_middle);
    };
    factory.stages = stages;
    factory.takes_actions = true;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
