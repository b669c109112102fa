// SPDX-License-Identifier: BSD-3-Clause
#include "methods/splitting/splitting.hpp"

#include <algorithm>

#include "methods/contract/integrator.hpp"
#include "methods/contract/take_over.hpp"
#include "methods/splitting/free_flow.hpp"
#include "methods/splitting/kick.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// b_1, ..., b_{s+1} and a_1, ..., a_s.
struct Palindromes {
    explicit Palindromes(const SplittingScheme& scheme) {
        for (const Coefficient& b : scheme.kicks) kicks.push_back(value(b));
        for (const Coefficient& a : scheme.drifts) drifts.push_back(value(a));
        const bool kick_in_middle = scheme.kicks.size() > scheme.drifts.size();
        mirror(kicks, kick_in_middle), mirror(drifts, !kick_in_middle);
    }
    static void mirror(std::vector<Real>& half, bool middle) {
        for (std::size_t i = half.size() - (middle ? 1 : 0); i > 0; --i) half.push_back(half[i - 1]);
    }
    std::vector<Real> kicks, drifts;
};

class Splitting final : public Integrator {
  public:
    Splitting(System& system, const SplittingScheme& scheme)
        : system_(system),
          flow_(system),
          kick_(system),
          scheme_(scheme),
          y_(static_cast<std::size_t>(system.state_group().size())) {}

    Status step(const Real& t, const Real& h, Real* y) override {
        std::copy_n(y, y_.size(), y_.begin());
        flow_.weigh(y);
        Real now = t;
        if (const Status status = kick_(now, scheme_.kicks[0] * h, y_.data()); status != Status::ok) return status;
        for (std::size_t i = 0; i < scheme_.drifts.size(); ++i) {
            drift(scheme_.drifts[i] * h);
            now = i + 1 < scheme_.drifts.size() ? Real(now + scheme_.drifts[i] * h) : Real(t + h);
            if (const Status status = kick_(now, scheme_.kicks[i + 1] * h, y_.data()); status != Status::ok)
                return status;
        }
        return take_over(y_, y);
    }

  private:
    void drift(const Real& a_h) {
        flow_.advance(a_h, y_.data(), system_.v(y_.data()));
        ++work_.exponentials;
    }

    System& system_;
    FreeFlow flow_;
    Kick kick_;
    Palindromes scheme_;
    std::vector<Real> y_;
};

std::string why_not_split(const System& system) {
    if (system.is_dissipative()) return "forces that depend on velocities (dampers)";
    return BodyInertias::why_not(system);
}

}  // namespace

std::vector<Claim> preserved_by_splitting() {
    return {{Property::symplectic, Domain::potential},
            {Property::symmetric, Domain::potential},
            {Property::momentum, Domain::potential},
            {Property::energy, Domain::free}};
}

Factory splitting(const SplittingScheme& scheme) {
    Factory factory;
    factory.make = [scheme](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<Splitting>(system, scheme);
    };
    factory.declines = why_not_split;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
