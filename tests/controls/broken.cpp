// SPDX-License-Identifier: BSD-3-Clause
#include "tests/controls/broken.hpp"

#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using Vector = std::vector<Real>;

/// Shared by both families: the slopes of the stages, each at its point and time.
class Broken : public Integrator {
  public:
    Broken(System& system, const Tableau& tableau)
        : system_(system), group_(system.state_group()), tableau_(tableau, 1), slopes_(tableau.b.size(), algebra()) {}

    Status step(const Real& t, const Real& h, Real* y) override {
        Vector point(static_cast<std::size_t>(group_.size()));
        for (std::size_t i = 0; i < slopes_.size(); ++i) {
            std::copy_n(y, point.size(), point.begin());
            Vector u = append(tableau_.a[i], h, point.data(), false);
            const Status status = find_slope(i, stage_time(t, h, i), point.data(), slopes_[i].data());
            if (status != Status::ok) return status;
            finish_slope(u, slopes_[i]);
        }
        append(tableau_.b, h, y, true);
        return finish(t + h, h, y);
    }

  protected:
    /// y <- the point that the weights and the slopes so far lead to; returns its coordinates around the old y.
    virtual Vector append(const Combination& weights, const Real& h, Real* y, bool final) = 0;
    virtual Status find_slope(std::size_t /*stage*/, const Real& t, const Real* point, Real* slope) {
        return system_.vector_field(t, point, slope);
    }
    virtual void finish_slope(const Vector& /*u*/, Vector& /*slope*/) const {}
    virtual Status finish(const Real& /*t*/, const Real& /*h*/, Real* /*y*/) { return Status::ok; }
    virtual Real stage_time(const Real& t, const Real& h, std::size_t i) const { return t + tableau_.c[i] * h; }

    Vector algebra() const { return Vector(static_cast<std::size_t>(group_.dim())); }

    System& system_;
    const TangentGroup& group_;
    BoundTableau tableau_;
    std::vector<Vector> slopes_;
};

class BrokenMuntheKaas final : public Broken {
  public:
    BrokenMuntheKaas(System& system, const Tableau& tableau, MuntheKaasFault fault)
        : Broken(system, tableau), fault_(fault), kept_(algebra()) {}

  private:
    Vector append(const Combination& weights, const Real& h, Real* y, bool) override {
        Vector u = algebra();
        for (const Term& term : weights)
            for (std::size_t j = 0; j < u.size(); ++j) u[j] += h * term.coefficient * slopes_[term.offset][j];
        group_.append_exp(y, u.data(), y);
        return u;
    }

    void finish_slope(const Vector& u, Vector& slope) const override {
        if (fault_.dexpinv == MuntheKaasFault::Dexpinv::absent) return;
        Vector around = u;
        if (fault_.dexpinv == MuntheKaasFault::Dexpinv::wrong_sign)
            for (Real& x : around) x = -x;
        group_.dexpinv_left(around.data(), slope.data(), slope.data());
    }

    Real stage_time(const Real& t, const Real& h, std::size_t i) const override {
        if (fault_.nodes == MuntheKaasFault::Nodes::middle) return t + h / 2;
        return fault_.nodes == MuntheKaasFault::Nodes::start ? t : Broken::stage_time(t, h, i);
    }

    Status find_slope(std::size_t stage, const Real& t, const Real* point, Real* slope) override {
        if (fault_.stale_slope && stage == 0 && has_kept_) {
            std::copy(kept_.begin(), kept_.end(), slope);
            return Status::ok;
        }
        if (fault_.uncounted_solve && stage == 0)
            system_.accelerations(t, point, point + group_.base().size(), slope + group_.base().dim(), nullptr);
        const Status status = system_.vector_field(t, point, slope);
        if (!fault_.deaf) return status;
        for (std::size_t j = 0; j < kept_.size(); ++j)
            if (!isfinite(slope[j])) slope[j] = 0;
        return Status::ok;
    }

    Status finish(const Real& t, const Real& h, Real* y) override {
        if (fault_.turns_space) turn_space(h * h * h, y);
        if (!fault_.stale_slope) return Status::ok;
        has_kept_ = true;
        return system_.vector_field(t, y, kept_.data());
    }

    /// y <- exp(angle (1, ..., 1; 0)) y: a motion of space, independent of y.
    void turn_space(const Real& angle, Real* y) const {
        Vector motion(static_cast<std::size_t>(group_.size())), u = algebra();
        std::fill_n(u.begin(), group_.base().dim(), angle);
        group_.identity(motion.data());
        group_.append_exp(motion.data(), u.data(), motion.data());
        group_.multiply(motion.data(), y, y);
    }

    MuntheKaasFault fault_;
    Vector kept_;
    bool has_kept_ = false;
};

class BrokenCrouchGrossman final : public Broken {
  public:
    BrokenCrouchGrossman(System& system, const Tableau& tableau, CrouchGrossmanFault fault)
        : Broken(system, tableau), fault_(fault) {}

  private:
    Vector append(const Combination& weights, const Real& h, Real* y, bool final) override {
        Combination factors = weights;
        if (final ? fault_.reversed_final_factors : fault_.reversed_stage_factors)
            std::reverse(factors.begin(), factors.end());
        for (const Term& term : factors) {
            Vector u = slopes_[term.offset];
            for (Real& x : u) x *= h * term.coefficient;
            group_.append_exp(y, u.data(), y);
        }
        return {};
    }

    CrouchGrossmanFault fault_;
};

}  // namespace

Factory broken_rkmk(const Tableau& declared, MuntheKaasFault fault) { return broken_rkmk(declared, fault, declared); }

Factory broken_rkmk(const Tableau& declared, MuntheKaasFault fault, const Tableau& used) {
    Factory factory;
    factory.make = [used, fault](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<BrokenMuntheKaas>(system, used, fault);
    };
    factory.stages = static_cast<int>(declared.b.size());
    factory.scheme = Scheme(MuntheKaasScheme{declared});
    return factory;
}

Factory broken_crouch_grossman(const Tableau& declared, CrouchGrossmanFault fault) {
    Factory factory;
    factory.make = [declared, fault](System& system, const OptionValues&, const MethodDescription&) {
        Tableau used = declared;
        if (fault.reversed_rows)
            for (auto& row : used.a) std::reverse(row.begin(), row.end());
        return std::make_unique<BrokenCrouchGrossman>(system, used, fault);
    };
    factory.stages = static_cast<int>(declared.b.size());
    factory.scheme = Scheme(CrouchGrossmanScheme{declared});
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
