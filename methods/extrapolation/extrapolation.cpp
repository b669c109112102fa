// SPDX-License-Identifier: BSD-3-Clause
#include "methods/extrapolation/extrapolation.hpp"

#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/extrapolation/chart_midpoint.hpp"
#include "methods/extrapolation/gragg_tableau.hpp"
#include "methods/extrapolation/group_midpoint.hpp"
#include "methods/extrapolation/neville.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class FixedExtrapolation final : public Integrator {
  public:
    FixedExtrapolation(System& system, const MakeExtrapolationBase& base, int columns)
        : columns_(columns), base_(base(system, work_)), table_(columns, system.state_group().dim()) {}

    Status start(const Real&, const Real*) override {
        first_known_ = false;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (const Status status = fill(t, h, y, false); status != Status::ok) return status;
        base_->state(table_.result(), y);
        first_known_ = false;
        return Status::ok;
    }

    Status attempt(const Real& t, const Real& h, const Real* y, Real* y_new, Real* error) override {
        if (const Status status = fill(t, h, y, first_known_); status != Status::ok) return status;
        base_->state(table_.result(), y_new);
        std::copy_n(table_.difference(), table_.dimension(), error);
        return Status::ok;
    }

    /// No row takes a slope at the end of a step: nothing is learnt for the next one.
    void accept(bool) override { first_known_ = false; }

  private:
    /// All rows; the result is in the table.
    Status fill(const Real& t, const Real& h, const Real* y, bool known) {
        first_known_ = false;
        if (const Status status = base_->begin(t, h, y, known); status != Status::ok) return status;
        first_known_ = true;  // until a step is accepted
        for (int j = 1; j <= columns_; ++j) {
            if (const Status status = base_->row(substeps(j), table_.row(j)); status != Status::ok) return status;
            table_.extrapolate(j);
        }
        return Status::ok;
    }

    int columns_;
    std::unique_ptr<ExtrapolationBase> base_;
    NevilleTable table_;
    bool first_known_ = false;  // the base method has the slope at y
};

Factory extrapolation(const MakeExtrapolationBase& base, int columns) {
    Factory factory;
    factory.make = [base, columns](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<FixedExtrapolation>(system, base, columns);
    };
    factory.stages = solves_of_rows(columns);
    return factory;
}

}  // namespace

Factory gragg(int columns) {
    Factory factory = extrapolation(chart_midpoint, columns);
    factory.scheme = Scheme(MuntheKaasScheme{gragg_tableau(columns)});
    return factory;
}

Factory lie_midpoint(int columns) {
    Factory factory = extrapolation(group_midpoint, columns);
    factory.scheme = Scheme(GroupExtrapolationScheme{columns});
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
