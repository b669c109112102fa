// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/forest.hpp"

#include <algorithm>
#include <numeric>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Of the joint graph: a body is its number, the ground comes after all of them.
std::size_t vertex(std::size_t bodies, int body) { return body == ground ? bodies : static_cast<std::size_t>(body); }

/// By vertex, in the order of the model.
std::vector<std::vector<int>> joints_by_vertex(const Model& model) {
    const std::size_t bodies = model.bodies.size();
    std::vector<std::vector<int>> joints(bodies + 1);
    for (std::size_t j = 0; j < model.joints.size(); ++j)
        for (const int body : {model.joints[j].first, model.joints[j].second})
            joints[vertex(bodies, body)].push_back(static_cast<int>(j));
    return joints;
}

/// Disjoint sets of bodies and, as the last element, the ground (union-find).
class Sets {
  public:
    explicit Sets(const Model& model) : root_(model.bodies.size() + 1) {
        std::iota(root_.begin(), root_.end(), std::size_t{0});
    }
    std::size_t find(int body) {
        std::size_t i = vertex(root_.size() - 1, body);
        while (root_[i] != i) i = root_[i] = root_[root_[i]];
        return i;
    }
    /// False if the two are in one set already.
    bool unite(int first, int second) {
        const std::size_t a = find(first), b = find(second);
        root_[a] = b;
        return a != b;
    }

  private:
    std::vector<std::size_t> root_;
};

}  // namespace

bool is_forest(const Model& model) {
    Sets sets(model);
    return std::all_of(model.joints.begin(), model.joints.end(),
                       [&](const Joint& joint) { return sets.unite(joint.first, joint.second); });
}

std::vector<std::size_t> islands(const Model& model) {
    Sets sets(model);
    for (const Joint& joint : model.joints)
        if (joint.first != ground && joint.second != ground) sets.unite(joint.first, joint.second);
    std::vector<std::size_t> island;
    for (const Joint& joint : model.joints)
        island.push_back(sets.find(joint.first == ground ? joint.second : joint.first));
    return island;
}

std::vector<Branch> branches(const Model& model) {
    const std::size_t bodies = model.bodies.size();
    const auto joints = joints_by_vertex(model);
    std::vector<Branch> all;
    std::vector<bool> placed(bodies + 1, false);
    const auto place = [&](const Branch& branch) {
        placed[vertex(bodies, branch.body)] = true;
        all.push_back(branch);
    };
    const auto hang_on = [&](int parent, int body) {
        for (const int j : joints[vertex(bodies, body)]) {
            const Joint& joint = model.joints[static_cast<std::size_t>(j)];
            const int other = joint.first == body ? joint.second : joint.first;
            if (other != ground && !placed[vertex(bodies, other)]) place({other, parent, j});
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
