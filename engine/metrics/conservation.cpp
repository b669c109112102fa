// SPDX-License-Identifier: BSD-3-Clause
#include "engine/metrics/conservation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const Real most_lost = Real(1) / 100;

}  // namespace

Conservation::Conservation(System& system, const Real* y)
    : system_(system),
      states_(static_cast<std::size_t>(system.bodies())),
      springs_(static_cast<std::size_t>(system.torsion_springs())),
      angles_(springs_.size()),
      start_(values(y)) {}

std::vector<Conservation::Value> Conservation::values(const Real* y) {
    system_.read(y, states_.data());
    system_.read_angles(y, springs_.data());
    for (std::size_t i = 0; i < angles_.size(); ++i) angles_[i] = springs_[i].theta;
    const MotionState state{states_, angles_};
    std::vector<Value> all;
    for (const FirstIntegral& integral : system_.integrals())
        all.push_back({integral.value(state), integral.size(state)});
    return all;
}

std::optional<LostIntegral> Conservation::lost(const Real* y) {
    const std::vector<Value> now = values(y);
    std::optional<LostIntegral> worst;
    Real largest = most_lost;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const Real share = abs(now[i].now - start_[i].now) / max(now[i].size, start_[i].size);
        if (!(share > largest) || !isfinite(share)) continue;  // 0/0 of an integral without terms: it is conserved
        largest = share;
        worst = LostIntegral{system_.integrals()[i].name, to_double(share)};
    }
    return worst;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
