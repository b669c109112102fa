// SPDX-License-Identifier: BSD-3-Clause
//
// A coordinate that is prescribed as a function of time,
//   f(t) = sum_k c_k t^k + sum_i A_i sin(W_i t + p_i).
#pragma once

#include <vector>

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The unit of A is that of the coordinate; W in rad/s, the phase p in rad.
struct Sinusoid {
    Real amplitude = 0, frequency = 0, phase = 0;
};

struct Prescribed {
    std::vector<Real> polynomial = {};  ///< c_0, c_1, ...
    std::vector<Sinusoid> sinusoids = {};

    bool is_zero() const { return polynomial.empty() && sinusoids.empty(); }

    /// f, f' and f'' at a time.
    struct Value {
        Real f = 0, rate = 0, second = 0;
    };
    Value at(const Real& t) const {
        Value value;
        for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) {
            value.second = value.second * t + 2 * value.rate;
            value.rate = value.rate * t + value.f;
            value.f = value.f * t + *c;
        }
        for (const auto& [amplitude, frequency, phase] : sinusoids) {
            const Real angle = frequency * t + phase, wave = amplitude * sin(angle);
            value.f += wave;
            value.rate += amplitude * frequency * cos(angle);
            value.second -= frequency * frequency * wave;
        }
        return value;
    }

    /// |c_1| + sum |A W|: how fast the coordinate moves near the start.
    Real pace() const {
        Real sum = polynomial.size() > 1 ? Real(abs(polynomial[1])) : Real(0);
        for (const Sinusoid& one : sinusoids) sum += abs(one.amplitude * one.frequency);
        return sum;
    }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
