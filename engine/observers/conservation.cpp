// SPDX-License-Identifier: BSD-3-Clause
#include "engine/observers/conservation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const Real most_lost = Real(1) / 100;

}  // namespace

Conservation::Conservation(Observation& start) : start_(values(start)) {}

std::vector<Conservation::Value> Conservation::values(Observation& now) {
    const MotionState state = now.motion();
    std::vector<Value> all;
    for (const FirstIntegral& integral : now.system().integrals())
        all.push_back({integral.value(state), integral.size(state)});
    return all;
}

std::optional<LostIntegral> Conservation::lost(Observation& now) const {
    const std::vector<Value> end = values(now);
    std::optional<LostIntegral> worst;
    Real largest = most_lost;
    for (std::size_t i = 0; i < end.size(); ++i) {
        const Real share = abs(end[i].now - start_[i].now) / max(end[i].size, start_[i].size);
        if (!(share > largest) || !isfinite(share)) continue;  // 0/0 of an integral without terms: it is conserved
        largest = share;
        worst = LostIntegral{now.system().integrals()[i].name, to_double(share)};
    }
    return worst;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
