// SPDX-License-Identifier: BSD-3-Clause
//
// Predicts the errors of generalised-alpha methods [arnold2015] on a symmetric heavy top in SE(3) and SO(3) x R^3. Run
// it by tools/leading-constants.
//
// To leading order a method of order two is the exact flow of modified equations: with the defects of a step,
//   d = C_q v'' + 1/12 [v, v']   in the increment, over h^3; the exact increment is
//                                h v + h^2/2 v' + h^3 (v''/6 + [v, v']/12),
//   e = C_v v'''                 in the velocity, over h^3,
//   C_q = 1/6 - beta - D/2,  C_v = 1/6 - D (alpha_m - 1/2) - gamma D - gamma/2,  D = alpha_m - alpha_f,
// it moves by q' = q (v - h^2 d), M v' + C^T lambda = Q - h^2 M e on the constraints. The multipliers leave of d and e
// what is tangent, in the metric of the kinetic energy. In SE(3) all of v, v', ... is tangent, in body axes. In SO(3) x
// R^3 the translational part of v'' and v''' is that of space axes, and P (e_x, e_w) = J_O^{-1} (J e_w + m X x e_x) is
// left. In the index-3 form constraints hold for positions alone, and v keeps the normal part of h^2 d.
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>

namespace {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

struct Top {
    double mass, lever, transverse, axial, spin, precession, gravity, t_end;
    Vec3 X() const { return {0, lever, 0}; }
};

struct Method {
    int index;    // of the constraints it solves for
    bool screws;  // SE(3), else SO(3) x R^3
    double C_q, C_v, C_b;
};

/// `C_b`: of the bracket, 1/12, or 0 to see what it does.
Method generalised_alpha(int index, bool screws, double rho, double C_b) {
    const double alpha_m = (2 * rho - 1) / (rho + 1), alpha_f = rho / (rho + 1), D = alpha_m - alpha_f;
    const double gamma = 0.5 - D, beta = (gamma + 0.5) * (gamma + 0.5) / 4;
    return {index, screws, 1. / 6 - beta - D / 2, 1. / 6 - D * (alpha_m - 0.5) - gamma * D - gamma / 2, C_b};
}

Mat3 hat(const Vec3& a) {
    Mat3 m;
    m << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
    return m;
}

struct State {
    Mat3 R;
    Vec3 omega;
};
State operator+(const State& a, const State& b) { return {a.R + b.R, a.omega + b.omega}; }
State operator*(double c, const State& a) { return {c * a.R, c * a.omega}; }

/// The derivatives of a vector with the components a_0 in body axes that turn with omega: its derivatives in space
/// axes, in body components, from those of its components and of omega.
std::array<Vec3, 4> in_space(const std::array<Vec3, 4>& a, const std::array<Vec3, 4>& w) {
    const auto once = [&w](const std::array<Vec3, 4>& b) {
        std::array<Vec3, 4> d = {};
        d[0] = b[1] + w[0].cross(b[0]);
        d[1] = b[2] + w[1].cross(b[0]) + w[0].cross(b[1]);
        d[2] = b[3] + w[2].cross(b[0]) + 2 * w[1].cross(b[1]) + w[0].cross(b[2]);
        return d;
    };
    const auto first = once(a), second = once(first);
    return {a[0], first[0], second[0], once(second)[0]};
}

class ModifiedEquations {
  public:
    ModifiedEquations(const Top& top, const Method& method, double h_squared)
        : method_(method), h2_(h_squared), m_(top.mass), g_(0, 0, -top.gravity), X_(top.X()) {
        J_ = Vec3(top.transverse, top.axial, top.transverse).asDiagonal();
        J_O_ = J_ - m_ * hat(X_) * hat(X_);
        inverse_ = J_O_.inverse();
    }
    State operator()(const State& y) const {
        const std::array<Vec3, 4> w = derivatives(y);
        const Vec3 d_w = method_.C_q * w[2] + method_.C_b * w[0].cross(w[1]), e_w = method_.C_v * w[3];
        Vec3 d = d_w, change = -h2_ * e_w;
        if (!method_.screws) {
            const auto x = in_space({w[0].cross(X_), w[1].cross(X_), w[2].cross(X_), w[3].cross(X_)}, w);
            d = tangent(method_.C_q * x[2], d_w);
            const Vec3 h2_d = h2_ * d;
            change = inverse_ * (m_ * X_.cross(h2_d.cross(x[0]))) - h2_ * tangent(method_.C_v * x[3], e_w);
            if (method_.index == 3) change += of_normal(method_.C_q * x[2] - d.cross(X_), d_w - d, w[0]);
        }
        return {y.R * hat(w[0] - h2_ * d), w[1] + change};
    }

  private:
    /// omega and its derivatives along the exact motion.
    std::array<Vec3, 4> derivatives(const State& y) const {
        const Vec3 w = y.omega, g = y.R.transpose() * g_;
        const Vec3 w1 = inverse_ * (m_ * X_.cross(g) - w.cross(J_O_ * w)), g1 = g.cross(w);
        const Vec3 w2 = inverse_ * (m_ * X_.cross(g1) - w1.cross(J_O_ * w) - w.cross(J_O_ * w1));
        const Vec3 g2 = g1.cross(w) + g.cross(w1);
        const Vec3 inner = w2.cross(J_O_ * w) + 2 * w1.cross(J_O_ * w1) + w.cross(J_O_ * w2);
        return {w, w1, w2, inverse_ * (m_ * X_.cross(g2) - inner)};
    }
    Vec3 tangent(const Vec3& e_x, const Vec3& e_w) const { return inverse_ * (J_ * e_w + m_ * X_.cross(e_x)); }
    /// What a normal part h^2 (n_x, n_w) of the velocity does to omega'.
    Vec3 of_normal(const Vec3& n_x, const Vec3& n_w, const Vec3& w) const {
        return -h2_ * inverse_ * (m_ * X_.cross(w.cross(n_x)) + n_w.cross(J_ * w) + w.cross(J_ * n_w));
    }

    Method method_;
    double h2_, m_;
    Vec3 g_, X_;
    Mat3 J_, J_O_, inverse_;
};

/// Gragg's rule, extrapolated to order ten.
State step(const ModifiedEquations& f, const State& y, double h) {
    constexpr int columns = 5;
    std::array<State, columns> row, last;
    for (int j = 0; j < columns; ++j) {
        const double s = h / (2 * j + 2);
        State before = y, now = y + s * f(y);
        for (int i = 1; i < 2 * j + 2; ++i) {
            const State next = before + 2 * s * f(now);
            before = now, now = next;
        }
        row[0] = 0.5 * (before + now + s * f(now));
        for (int k = 1; k <= j; ++k) {
            const double q = double(j + 1) / (j + 1 - k);
            row[std::size_t(k)] =
                row[std::size_t(k - 1)] + 1 / (q * q - 1) * (row[std::size_t(k - 1)] + -1 * last[std::size_t(k - 1)]);
        }
        last = row;
    }
    return last[columns - 1];
}

Vec3 mass_centre(const Top& top, const Method& method, double h_squared) {
    const ModifiedEquations f(top, method, h_squared);
    State y{Mat3::Identity(), {0, top.spin, top.precession}};
    const int steps = std::max(200, int(6 * top.t_end * top.spin));
    for (int i = 0; i < steps; ++i) y = step(f, y, top.t_end / steps);
    return y.R * top.X();
}

/// |dx/d(h^2)| at the end, m/s^2.
double leading_constant(const Top& top, const Method& method) {
    const double small = 2e-5 / (top.spin * top.spin);
    return (mass_centre(top, method, small) - mass_centre(top, method, -small)).norm() / (2 * small);
}

}  // namespace

// Lines "index formulation rho mass lever transverse axial spin precession gravity t_end"; for each the constant, and
// what it would be without the bracket.
int main() {
    int index = 0;
    std::string formulation;
    double rho = 0;
    Top top{};
    while (std::cin >> index >> formulation >> rho >> top.mass >> top.lever >> top.transverse >> top.axial >>
           top.spin >> top.precession >> top.gravity >> top.t_end)
        std::printf("%.6g,%.6g\n", leading_constant(top, generalised_alpha(index, formulation == "SE3", rho, 1. / 12)),
                    leading_constant(top, generalised_alpha(index, formulation == "SE3", rho, 0)));
    return std::cin.eof() ? 0 : 1;
}
