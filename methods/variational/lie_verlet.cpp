// SPDX-License-Identifier: BSD-3-Clause
//
// The Lie-Verlet method (Stoermer-Verlet on a group) for bodies without joints: half a kick by the forces, a discrete
// free motion, half a kick. With p = M v,
//   p <- p + h/2 f(t, q),   x+ = x + h p/m,   R+ = R tau(u),   R+ p+ = R p,   p <- p + h/2 f(t + h, q+),
// u from the momentum by the equation of methods/variational/discrete_rotation.hpp, three unknowns of each body;
// explicit otherwise. The option `coordinates` decides it:
//   matrix       differences of rotation matrices: the discrete Moser-Veselov algorithm between kicks, which is RATTLE
//                for a matrix R with R^T R = I [mclachlanscovel1995], [hairer2006, Sec. VII.5.3],
//                [leeleokmcclamroch2007];
//   cayley, exp  the coordinates of increments [bourabeemarsden2009]: what RATTLie is without joints.
// Symplectic where f has a potential, symmetric; momenta change by kicks only.
#include <Eigen/LU>
#include <algorithm>

#include "mechanics/free_body/inertias.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/take_over.hpp"
#include "methods/splitting/kick.hpp"
#include "methods/variational/discrete_rotation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class LieVerlet final : public Integrator {
  public:
    LieVerlet(System& system, RotationDistance distance)
        : system_(system),
          distance_(distance),
          inertias_(system),
          kick_(system),
          y_(static_cast<std::size_t>(system.state_group().size())),
          u_(static_cast<std::size_t>(system.velocities())),
          rate_(u_) {
        bodies_.reserve(static_cast<std::size_t>(inertias_.bodies()));
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.accelerations(t, y, system_.v(y), rate_.data(), nullptr);
        weigh(y);
        std::copy_n(y, y_.size(), y_.begin());
        Status status = kick_(t, h / 2, y_.data());
        if (status == Status::ok) status = drift(h);
        if (status == Status::ok) status = kick_(t + h, h / 2, y_.data());
        if (status != Status::ok) return status;
        return take_over(y_, y);
    }

  private:
    struct Inertia {
        Mat3 J, inverse;
    };

    Status drift(const Real& h) {
        Real *v = system_.v(y_.data()), *u = u_.data();
        for (const Inertia& body : bodies_) {
            if (inertias_.in_space()) {
                store(Vec3(h * vec3(v)), u);
                u += 3, v += 3;
            }
            DiscreteRotation rotation(distance_, body.J, body.inverse, body.J * vec3(v), h);
            if (const Status status = rotation.solve(work_.newton_iterations); status != Status::ok) return status;
            store(rotation.increment(), u);
            store(Vec3(vec3(v) + body.inverse * rotation.gained_momentum()), v);  // not J^{-1} J omega
            u += 3, v += 3;
        }
        const Group& group = system_.group();
        distance_ == RotationDistance::exp ? group.append_exp(y_.data(), u_.data(), y_.data())
                                           : group.append_cay(y_.data(), u_.data(), y_.data());
        ++work_.exponentials;
        return Status::ok;
    }

    void weigh(const Real* q) {
        if (!inertias_.weigh(q)) return;
        bodies_.clear();
        for (int i = 0; i < inertias_.bodies(); ++i) bodies_.push_back({inertias_.of(i), inertias_.of(i).inverse()});
    }

    System& system_;
    RotationDistance distance_;
    BodyInertias inertias_;
    Kick kick_;
    std::vector<Real> y_, u_, rate_;
    std::vector<Inertia> bodies_;
};

RotationDistance distance_of(const std::string& coordinates) {
    if (coordinates == "exp") return RotationDistance::exp;
    return coordinates == "cayley" ? RotationDistance::cayley : RotationDistance::matrix;
}

std::string why_not_unconstrained(const System& system) {
    if (system.is_dissipative()) return "forces that depend on velocities (dampers)";
    return BodyInertias::why_not(system);
}

Factory lie_verlet() {
    Factory factory;
    factory.options = {{.name = "coordinates",
                        .summary = "of increments: differences of rotation matrices, Cayley or exponential map",
                        .standard = std::string("matrix"),
                        .choices = {"matrix", "cayley", "exp"}}};
    factory.make = [](System& system, const OptionValues& options, const MethodDescription&) {
        return std::make_unique<LieVerlet>(system, distance_of(std::get<std::string>(options.at("coordinates"))));
    };
    factory.declines = why_not_unconstrained;
    return factory;
}

}  // namespace

KREISEL_METHOD(lie_verlet(), {.name = "variational/lie_verlet",
                              .order = 2,
                              .cites = {"bourabeemarsden2009", "leeleokmcclamroch2007", "mclachlanscovel1995",
                                        "moserveselov1991", "hairer2006"},
                              .summary = "Lie-Verlet, Stoermer-Verlet on a group: discrete free motion of bodies "
                                         "between kicks, Cayley coordinates among them",
                              .force_evaluations = 2,
                              .form = Form::implicit,
                              .preserves = {{Property::symplectic, Domain::potential},
                                            {Property::symmetric, Domain::potential},
                                            {Property::momentum, Domain::potential}},
                              .formulations = {"SO3", "S3", "SO3xR3", "S3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
