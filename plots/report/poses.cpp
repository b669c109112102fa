// SPDX-License-Identifier: BSD-3-Clause
#include "plots/report/poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "records/reading/trajectory_table.hpp"
#include "support/base64.hpp"

namespace kreisel {

namespace {

template <class Unsigned>
void append_bytes(Unsigned bits, std::string& bytes) {
    for (std::size_t i = 0; i < sizeof bits; ++i) { bytes += static_cast<char>((bits >> (8 * i)) & 0xffU); }
}

void append_bytes(double value, std::string& bytes) { append_bytes(std::bit_cast<std::uint64_t>(value), bytes); }

const std::vector<double>& samples_named(const TrajectoryTable& trajectory, const std::string& name) {
    const auto* column = trajectory.find(name);
    if (column == nullptr) { throw std::out_of_range("the samples hold no " + name); }
    return *column;
}

using Columns = std::vector<const std::vector<double>*>;

// Those of each body with these numbers.
Columns columns_of(const TrajectoryTable& trajectory, const std::vector<std::string>& bodies,
                   const std::vector<std::string>& numbers) {
    Columns columns;
    for (const std::string& body : bodies) {
        for (const std::string& number : numbers) {
            columns.push_back(&samples_named(trajectory, body + "." + number));
        }
    }
    return columns;
}

// No number where it is beyond the shorter kind.
float shortened(double value) {
    return std::abs(value) < std::numeric_limits<float>::max() ? static_cast<float>(value)
                                                               : std::numeric_limits<float>::quiet_NaN();
}

void put_velocities(const Columns& v, const std::vector<std::size_t>& instants, std::string& bytes) {
    for (const std::size_t k : instants) {
        for (const auto* column : v) { append_bytes(std::bit_cast<std::uint32_t>(shortened((*column)[k])), bytes); }
    }
}

void put_rotations(const Columns& R, const std::vector<std::size_t>& instants, std::string& bytes) {
    std::vector<std::array<double, 4>> last(R.size() / 9, {1, 0, 0, 0});
    for (const std::size_t k : instants) {
        for (std::size_t body = 0; body < last.size(); ++body) {
            std::array<double, 9> rows{};
            for (std::size_t i = 0; i < 9; ++i) { rows[i] = (*R[9 * body + i])[k]; }
            last[body] = quaternion_of(rows, last[body]);
            for (const double part : last[body]) {
                append_bytes(static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(32767 * part))), bytes);
            }
        }
    }
}

}  // namespace

std::array<double, 4> quaternion_of(const std::array<double, 9>& R, const std::array<double, 4>& near) {
    const auto at = [&](std::size_t i, std::size_t j) { return R[3 * i + j]; };
    std::array<double, 4> q{};
    const double trace = at(0, 0) + at(1, 1) + at(2, 2);
    if (trace > 0) {
        q = {1 + trace, at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1)};
    } else {
        std::size_t i = at(1, 1) > at(0, 0) ? 1 : 0;
        i = at(2, 2) > at(i, i) ? 2 : i;
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        q[0] = at(k, j) - at(j, k);
        q[1 + i] = 1 + at(i, i) - at(j, j) - at(k, k);
        q[1 + j] = at(j, i) + at(i, j);
        q[1 + k] = at(k, i) + at(i, k);
    }
    double square = 0, along = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        square += q[i] * q[i];
        along += q[i] * near[i];
    }
    if (!(square > 0) || !std::isfinite(square)) { return near; }
    for (double& part : q) { part /= std::copysign(std::sqrt(square), along); }
    return q;
}

std::vector<std::size_t> thinned(std::size_t samples, std::size_t most) {
    std::vector<std::size_t> indices;
    const std::size_t step = samples <= most ? 1 : (samples - 2) / (most - 1) + 1;
    for (std::size_t i = 0; i < samples; i += step) { indices.push_back(i); }
    if (!indices.empty() && indices.back() + 1 != samples) { indices.push_back(samples - 1); }
    return indices;
}

std::vector<std::string> bodies_in(const TrajectoryTable& trajectory) {
    std::vector<std::string> bodies;
    for (const std::string& name : trajectory.names) {
        if (name.ends_with(".x1")) { bodies.push_back(name.substr(0, name.size() - 3)); }
    }
    return bodies;
}

PackedPoses packed_poses(const TrajectoryTable& trajectory, const std::vector<std::string>& bodies,
                         const std::vector<std::size_t>& instants) {
    std::string t, x, q, v;
    const Columns positions = columns_of(trajectory, bodies, {"x1", "x2", "x3"});
    const auto& times = samples_named(trajectory, "t");
    for (const std::size_t k : instants) {
        append_bytes(times[k], t);
        for (const auto* column : positions) { append_bytes((*column)[k], x); }
    }
    const auto holds = [&](const char* number) {
        return !bodies.empty() && trajectory.find(bodies.front() + number) != nullptr;
    };
    if (holds(".R11")) {
        const std::vector<std::string> rows = {"R11", "R12", "R13", "R21", "R22", "R23", "R31", "R32", "R33"};
        put_rotations(columns_of(trajectory, bodies, rows), instants, q);
    }
    if (holds(".v1")) { put_velocities(columns_of(trajectory, bodies, {"v1", "v2", "v3"}), instants, v); }
    return {base64_text(t), base64_text(x), base64_text(q), base64_text(v)};
}

}  // namespace kreisel
