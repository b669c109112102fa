// SPDX-License-Identifier: BSD-3-Clause
#include "methods/baseline/global_coordinates.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "mechanics/system.hpp"
#include "methods/baseline/global_equations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using Flat = std::vector<Real>;

class GlobalRk4 final : public Integrator {
  public:
    GlobalRk4(System& system, std::shared_ptr<const RotationCoordinates> coordinates)
        : size_(system.state_group().size()), equations_(system, std::move(coordinates)), w_(equations_.size()) {
        stepper_.adjust_size(w_);
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        // Coordinates may not depend on every entry of R: a NaN would be repaired silently.
        if (!Eigen::Map<const VecX>(y, size_).allFinite()) return Status::non_finite;
        equations_.read(y, w_.data());
        status_ = Status::ok, h_ = h;
        stepper_.do_step([this](const Flat& w, Flat& dw, const Real& s) { derivative(w, dw, s); }, w_, t, h);
        if (status_ != Status::ok) return status_;
        equations_.finish(w_.data());
        equations_.write(w_.data(), y);
        return Status::ok;
    }

  private:
    /// The first failure of a step is kept; Odeint has no way to stop inside one.
    void derivative(const Flat& w, Flat& dw, const Real& t) {
        const Status status = equations_.derivative(t, w.data(), h_, dw.data());
        if (status_ == Status::ok) status_ = status;
    }

    int size_;
    GlobalEquations equations_;
    Flat w_;
    Status status_ = Status::ok;
    Real h_ = 0;
    boost::numeric::odeint::runge_kutta4<Flat, Real> stepper_;
};

}  // namespace

Factory global_rk4(const std::function<std::shared_ptr<const RotationCoordinates>(const OptionValues&)>& coordinates,
                   std::vector<OptionDescription> options) {
    Factory factory;
    factory.make = [coordinates](System& system, const OptionValues& values, const MethodDescription&) {
        return std::make_unique<GlobalRk4>(system, coordinates(values));
    };
    factory.options = std::move(options);
    factory.stages = 4;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
