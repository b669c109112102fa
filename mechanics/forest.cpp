// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/forest.hpp"

#include <numeric>

namespace kreisel {
inline namespace KREISEL_PRECISION {

bool is_forest(const Model& model) {
    std::vector<std::size_t> root(model.bodies.size() + 1);  // the last is the ground
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](int body) {
        std::size_t i = body == ground ? model.bodies.size() : static_cast<std::size_t>(body);
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    for (const Joint& joint : model.joints) {
        const std::size_t first = find(joint.first), second = find(joint.second);
        if (first == second) return false;
        root[first] = second;
    }
    return true;
}

std::vector<Branch> branches(const Model& model) {
    const std::size_t bodies = model.bodies.size();
    const auto vertex = [&](int body) { return body == ground ? bodies : static_cast<std::size_t>(body); };
    std::vector<std::vector<int>> joints(bodies + 1);
    for (std::size_t j = 0; j < model.joints.size(); ++j)
        for (const int body : {model.joints[j].first, model.joints[j].second})
            joints[vertex(body)].push_back(static_cast<int>(j));

    std::vector<Branch> all;
    std::vector<bool> placed(bodies + 1, false);
    const auto place = [&](const Branch& branch) {
        placed[vertex(branch.body)] = true;
        all.push_back(branch);
    };
    const auto hang_on = [&](int parent, int body) {
        for (const int j : joints[vertex(body)]) {
            const Joint& joint = model.joints[static_cast<std::size_t>(j)];
            const int other = joint.first == body ? joint.second : joint.first;
            if (other != ground && !placed[vertex(other)]) place({other, parent, j});
        }
    };
    std::size_t grown = 0;
    const auto grow = [&] {
        for (; grown < all.size(); ++grown) hang_on(static_cast<int>(grown), all[grown].body);
    };
    hang_on(-1, ground);
    grow();
    for (std::size_t body = 0; body < bodies; ++body) {
        if (placed[body]) continue;
        place({static_cast<int>(body), -1, -1});
        grow();
    }
    return all;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
