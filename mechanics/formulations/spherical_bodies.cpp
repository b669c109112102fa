// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/formulations/spherical_bodies.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "mechanics/solve/forest.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// R hat(r)^T: column k is R (e_k x r).
Mat3 arm(const auto& R, const Vec3& r) {
    Mat3 A;
    A << r[1] * R.col(2) - r[2] * R.col(1), r[2] * R.col(0) - r[0] * R.col(2), r[0] * R.col(1) - r[1] * R.col(0);
    return A;
}

/// D^{-1} = adjugate / determinant of a symmetric D: products with the adjugate need not wait for the division.
struct SymmetricInverse {
    explicit SymmetricInverse(const Mat3& D) {
        const Vec3 c0 = D.col(1).cross(D.col(2)), c1 = D.col(2).cross(D.col(0));
        adjugate << c0[0], c0[1], c0[2], c0[1], c1[1], c1[2], c0[2], c1[2], D(0, 0) * D(1, 1) - D(0, 1) * D(0, 1);
        factor = 1 / D.col(0).dot(c0);
    }
    Mat3 adjugate;
    Real factor;
};

/// M -= factor H B^T, which is symmetric.
void subtract_symmetric(Mat3& M, const Mat3& H, const Mat3& B, const Real& factor) {
    for (int j = 0; j < 3; ++j)
        for (int i = j; i < 3; ++i) M(j, i) = M(i, j) -= factor * H.row(i).dot(B.row(j));
}

/// D += Z^T Y, which is symmetric.
void add_symmetric(Mat3& D, const Mat3& Z, const Mat3& Y) {
    for (int j = 0; j < 3; ++j)
        for (int i = j; i < 3; ++i) D(j, i) = D(i, j) += Z.col(i).dot(Y.col(j));
}

/// a with M a + f = 0.
Vec3 free_acceleration(const Mat3& M, const Vec3& f) {
    const SymmetricInverse inverse(M);
    return -inverse.factor * (inverse.adjugate * f);
}

Vec3 centripetal(const auto& R, const Vec3& omega, const Vec3& r) { return R * omega.cross(omega.cross(r)); }

}  // namespace

template <class Coordinates>
bool SphericalBodies<Coordinates>::fits(const Model& model) {
    return all_spherical(model) && is_forest(model);
}

template <class Coordinates>
SphericalBodies<Coordinates>::SphericalBodies(Model data)
    : Base(std::move(data)), wrenches_(this->model().bodies.size()), forces_(has_forces(this->model())) {
    for (const Branch& branch : branches(this->model())) add_node(branch);
    prepared_.resize(nodes_.size());
    find_anchored();
}

template <class Coordinates>
void SphericalBodies<Coordinates>::add_node(const Branch& branch) {
    const Body& body = this->model().bodies[static_cast<std::size_t>(branch.body)];
    Node node{
        .body = branch.body, .joint = branch.joint, .rooted = branch.parent == none, .mass = body.mass, .J = body.J};
    if (branch.joint != none) {
        const Joint& joint = this->model().joints[static_cast<std::size_t>(branch.joint)];
        const bool second = joint.second == branch.body;
        const Vec3 &own = second ? joint.r_second : joint.r_first, &others = second ? joint.r_first : joint.r_second;
        node.sign = second ? 1 : -1;
        node.d = -own;
        node.J = inertia_about(body, node.d);
        if (branch.parent != none) {
            Node& parent = nodes_[static_cast<std::size_t>(branch.parent)];
            node.s = others + parent.d;
            node.sibling = std::exchange(parent.child, static_cast<int>(nodes_.size()));
        }
    }
    nodes_.push_back(node);
}

template <class Coordinates>
void SphericalBodies<Coordinates>::find_anchored() {
    const bool apart = std::all_of(nodes_.begin(), nodes_.end(), [](const Node& node) { return node.rooted; });
    if (forces_ || !apart) return;
    anchored_.resize(nodes_.size());
    for (const Node& node : nodes_) {
        const Body& body = this->model().bodies[static_cast<std::size_t>(node.body)];
        const Vec3 r = -node.d;
        const Mat3 J_inverse = body.J.inverse(), J_inverse_r = J_inverse * hat(r);
        const Mat3 S = inverse_mass(body) * Mat3::Identity() - hat(r) * J_inverse_r;
        anchored_[static_cast<std::size_t>(node.body)] = {node.joint,
                                                          node.sign,
                                                          inverse_mass(body),
                                                          body.J,
                                                          J_inverse,
                                                          J_inverse_r,
                                                          node.joint == none ? Mat3(Mat3::Zero()) : Mat3(S.inverse()),
                                                          r};
    }
}

template <class Coordinates>
KREISEL_HOT Status SphericalBodies<Coordinates>::anchored_accelerations(const Real& t, const Real* q, const Real* v,
                                                                        Real* dv) const {
    Vec3 modulated;
    const Gravity& gravity = this->model().gravity;
    const Vec3& g = gravity.is_constant() ? gravity.g : (modulated = gravity.at(t));
    Real sum = 0;
    for (const Anchored& body : anchored_) {
        const auto R = Coordinates::Rotations::rotation(q + 3);
        const Vec3 w = vec3(v + 3), r = body.r, Jw = body.J * w;
        Vec3 A = R.transpose() * g;
        Vec3 dw = body.J_inverse * Jw.cross(w);
        const Vec3 mu = body.S_inverse * (A + dw.cross(r) + w.cross(w.cross(r)));  // minus the joint's force
        A -= body.inverse_mass * mu;
        dw -= body.J_inverse_r * mu;
        const Vec3 a = Coordinates::acceleration(R, A, w, vec3(v));
        sum += (a[0] + a[1] + a[2]) + (dw[0] + dw[1] + dw[2]);
        store(a, dv), store(dw, dv + 3);
        q += Factor::size, v += 6, dv += 6;
    }
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

template <class Coordinates>
template <class Act>
void SphericalBodies<Coordinates>::inwards(const Real* q, Act act) {
    for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
        const auto R = rotation(q, node->body);
        const Action action = act(*node);
        const Mat3 X = arm(R, node->d);
        node->c_d = centripetal(R, action.omega, node->d);
        Mat3 D = node->J, B = node->mass * X, M = node->mass * Mat3::Identity();
        Vec3 h = action.omega.cross(node->J * action.omega) - action.torque - X.transpose() * action.force;
        Vec3 f = node->mass * node->c_d - action.force;
        for (int c = node->child; c != none; c = nodes_[static_cast<std::size_t>(c)].sibling) {
            Node& child = nodes_[static_cast<std::size_t>(c)];
            child.c_s = centripetal(R, action.omega, child.s);
            const Mat3 Z = arm(R, child.s), Y = child.M * Z;
            const Vec3 force = child.M * child.c_s + child.f;
            add_symmetric(D, Z, Y), B += Y, M += child.M;
            h += Z.transpose() * force, f += force;
        }
        const SymmetricInverse inverse(D);
        const Mat3 H = B * inverse.adjugate;
        subtract_symmetric(M, H, B, inverse.factor);
        node->M = M, node->f = f - inverse.factor * (H * h);
        node->G = inverse.factor * H, node->k = inverse.factor * (inverse.adjugate * h);
    }
}

template <class Coordinates>
template <class Put>
void SphericalBodies<Coordinates>::outwards(const Real* q, Put put) {
    for (Node& node : nodes_) {
        if (node.rooted) node.a = node.joint == none ? free_acceleration(node.M, node.f) : node.c_s;
        const auto R = rotation(q, node.body);
        const Vec3 dw = -(node.G.transpose() * node.a) - node.k;
        for (int c = node.child; c != none; c = nodes_[static_cast<std::size_t>(c)].sibling) {
            Node& child = nodes_[static_cast<std::size_t>(c)];
            child.a = node.a + R * dw.cross(child.s) + child.c_s;
        }
        put(node, R, Vec3(node.a + R * dw.cross(node.d) + node.c_d), dw);
    }
}

template <class Coordinates>
void SphericalBodies<Coordinates>::add_wrenches(const Real& t, const Real* q, const Real* v) {
    std::fill(wrenches_.begin(), wrenches_.end(), Wrench());
    for_each_wrench(
        this->model(), t, [&](int body) { return motion(q, v, body); },
        [&](std::size_t i, const Turn& turn) { return this->turns().angle(i, turn, t, this->labels(q)); },
        [&](int body, const Wrench& wrench) {
            wrenches_[static_cast<std::size_t>(body)].force += rotation(q, body) * wrench.force;
            wrenches_[static_cast<std::size_t>(body)].torque += wrench.torque;
        });
}

template <class Coordinates>
Status SphericalBodies<Coordinates>::accelerations(const Real& t, const Real* q, const Real* v, Real* dv,
                                                   Real* lambda) {
    if (!anchored_.empty() && !lambda) return anchored_accelerations(t, q, v, dv);
    return forest_accelerations(t, q, v, dv, lambda);
}

template <class Coordinates>
KREISEL_HOT Status SphericalBodies<Coordinates>::forest_accelerations(const Real& t, const Real* q, const Real* v,
                                                                      Real* dv, Real* lambda) {
    const Vec3 g = this->model().gravity.at(t);
    const bool forces = forces_;
    if (forces) add_wrenches(t, q, v);
    for (Node& node : nodes_)
        if (node.rooted) node.c_s.setZero();  // the ground does not move
    inwards(q, [&](const Node& node) {
        Action action{angular(v, node.body), node.mass * g, Vec3::Zero()};
        if (forces) {
            const Wrench& wrench = wrenches_[static_cast<std::size_t>(node.body)];
            action.force += wrench.force, action.torque = wrench.torque;
        }
        return action;
    });
    Real sum = 0;
    outwards(q, [&](const Node& node, const auto& R, const Vec3& acceleration, const Vec3& dw) {
        const Vec3 a =
            Coordinates::from_space_acceleration(R, acceleration, angular(v, node.body), linear(v, node.body));
        sum += a.sum() + dw.sum();
        store(a, dv + 6 * node.body), store(dw, dv + 6 * node.body + 3);
    });
    if (lambda) report_multipliers(lambda);
    return isfinite(sum) ? this->turns().status() : Status::non_finite;
}

template <class Coordinates>
Status SphericalBodies<Coordinates>::solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a,
                                               Real* lambda) {
    const Status status = prepare_kkt(t, q);
    return status == Status::ok ? solve_prepared(t, q, f, c, a, lambda) : status;
}

template <class Coordinates>
Status SphericalBodies<Coordinates>::solve_prepared(const Real&, const Real* q, const Real* f, const Real* c, Real* a,
                                                    Real* lambda) {
    return anchored_.empty() ? forest_solve(q, f, c, a, lambda) : anchored_solve(q, f, c, a, lambda);
}

template <class Coordinates>
KREISEL_HOT Status SphericalBodies<Coordinates>::anchored_solve(const Real* q, const Real* f, const Real* c, Real* a,
                                                                Real* lambda) const {
    Real sum = 0;
    for (const Anchored& body : anchored_) {
        const auto R = Coordinates::Rotations::rotation(q + 3);
        Vec3 A = body.inverse_mass * Coordinates::to_body(R, vec3(f)), dw = body.J_inverse * vec3(f + 3);
        if (body.joint != none) {  // the rows demand the acceleration of the first body's point less the second's
            const Vec3 demanded = body.sign * (R.transpose() * vec3(c + 3 * body.joint));
            const Vec3 mu = body.S_inverse * (A + dw.cross(body.r) + demanded);  // minus the joint's force
            A -= body.inverse_mass * mu;
            dw -= body.J_inverse_r * mu;
            if (lambda) store(Vec3(-body.sign * (R * mu)), lambda + 3 * body.joint);
        }
        const Vec3 out = Coordinates::from_body(R, A);
        sum += (out[0] + out[1] + out[2]) + (dw[0] + dw[1] + dw[2]);
        store(out, a), store(dw, a + 3);
        q += Factor::size, f += 6, a += 6;
    }
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

/// The part of `inwards` that does not depend on forces.
template <class Coordinates>
KREISEL_HOT Status SphericalBodies<Coordinates>::prepare_kkt(const Real&, const Real* q) {
    if (!anchored_.empty()) return Status::ok;  // nothing depends on the configuration
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        const Node& node = nodes_[i];
        Prepared& prepared = prepared_[i];
        const auto R = rotation(q, node.body);
        prepared.X = arm(R, node.d);
        Mat3 D = node.J, B = node.mass * prepared.X, M = node.mass * Mat3::Identity();
        for (int c = node.child; c != none; c = nodes_[static_cast<std::size_t>(c)].sibling) {
            Prepared& child = prepared_[static_cast<std::size_t>(c)];
            child.Z = arm(R, nodes_[static_cast<std::size_t>(c)].s);
            const Mat3 Y = child.M * child.Z;
            add_symmetric(D, child.Z, Y), B += Y, M += child.M;
        }
        const SymmetricInverse inverse(D);
        const Mat3 H = B * inverse.adjugate;
        subtract_symmetric(M, H, B, inverse.factor);
        prepared.M = M, prepared.G = inverse.factor * H, prepared.D_inverse = inverse.factor * inverse.adjugate;
    }
    return Status::ok;
}

template <class Coordinates>
KREISEL_HOT Status SphericalBodies<Coordinates>::forest_solve(const Real* q, const Real* f, const Real* c, Real* a,
                                                              Real* lambda) {
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        const Node& node = nodes_[i];
        Prepared& prepared = prepared_[i];
        const Vec3 F = Coordinates::to_space(rotation(q, node.body), vec3(f + 6 * node.body));
        Vec3 h = -vec3(f + 6 * node.body + 3) - prepared.X.transpose() * F, force = -F;
        for (int k = node.child; k != none; k = nodes_[static_cast<std::size_t>(k)].sibling) {
            const Prepared& child = prepared_[static_cast<std::size_t>(k)];
            const Vec3 pull = child.M * child.c_s + child.f;
            h += child.Z.transpose() * pull, force += pull;
        }
        // The rows demand the acceleration of the first body's point less the second's.
        prepared.c_s.setZero();
        if (node.joint != none) prepared.c_s = -node.sign * vec3(c + 3 * node.joint);
        prepared.f = force - prepared.G * h, prepared.k = prepared.D_inverse * h;
    }
    Real sum = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const Node& node = nodes_[i];
        Prepared& prepared = prepared_[i];
        if (node.rooted) prepared.a = node.joint == none ? free_acceleration(prepared.M, prepared.f) : prepared.c_s;
        const Vec3 dw = -(prepared.G.transpose() * prepared.a) - prepared.k;
        for (int k = node.child; k != none; k = nodes_[static_cast<std::size_t>(k)].sibling) {
            Prepared& child = prepared_[static_cast<std::size_t>(k)];
            child.a = prepared.a + child.Z * dw + child.c_s;
        }
        const Vec3 out = Coordinates::from_space(rotation(q, node.body), Vec3(prepared.a + prepared.X * dw));
        sum += out.sum() + dw.sum();
        store(out, a + 6 * node.body), store(dw, a + 6 * node.body + 3);
        if (lambda && node.joint != none)
            store(Vec3(node.sign * (prepared.M * prepared.a + prepared.f)), lambda + 3 * node.joint);
    }
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

template <class Coordinates>
void SphericalBodies<Coordinates>::report_multipliers(Real* lambda) const {
    for (const Node& node : nodes_)
        if (node.joint != none) store(Vec3(node.sign * (node.M * node.a + node.f)), lambda + 3 * node.joint);
}

template class SphericalBodies<SO3xR3Coordinates>;
template class SphericalBodies<SE3Coordinates>;
template class SphericalBodies<S3xR3Coordinates>;

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
