// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/deal.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

namespace kreisel {

namespace {

// Which bin each item is in, and what the bins cost, the dearest first.
struct Balance {
    std::vector<std::size_t> bins;
    std::vector<double> costs;
};

// The dearest item first, of equal ones the earlier; each to the cheapest bin, of equal ones the first.
Balance balance(const std::vector<double>& items, std::size_t bins) {
    std::vector<std::size_t> order(items.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return items[a] > items[b]; });
    Balance result{std::vector<std::size_t>(items.size()), std::vector<double>(bins, 0)};
    for (const std::size_t item : order) {
        const auto cheapest = std::min_element(result.costs.begin(), result.costs.end());
        *cheapest += items[item];
        result.bins[item] = static_cast<std::size_t>(cheapest - result.costs.begin());
    }
    std::sort(result.costs.begin(), result.costs.end(), std::greater());
    return result;
}

// Cells that stay together.
struct Piece {
    double cost = 0;
    std::vector<std::size_t> cells;
};

// The cells of one reference, in pieces each of which pays for it.
struct Group {
    double reference = 0;
    std::vector<std::size_t> cells;
    std::vector<Piece> pieces = {};

    void split(const Plan& plan, std::size_t count) {
        std::vector<double> costs;
        for (const std::size_t cell : cells) { costs.push_back(plan.cells[cell].weight); }
        const Balance balanced = balance(costs, count);
        pieces.assign(count, {reference, {}});
        for (std::size_t i = 0; i < cells.size(); ++i) {
            Piece& piece = pieces[balanced.bins[i]];
            piece.cost += costs[i];
            piece.cells.push_back(cells[i]);
        }
    }
    double dearest() const { return std::ranges::max_element(pieces, {}, &Piece::cost)->cost; }
};

// A cell without a reference is a group of its own.
std::vector<Group> groups_of(const Plan& plan) {
    std::vector<Group> groups;
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const std::string& hash = plan.cells[i].reference();
        const auto found = hash.empty() ? known.end() : known.find(hash);
        if (found != known.end()) {
            groups[found->second].cells.push_back(i);
            continue;
        }
        if (!hash.empty()) { known.emplace(hash, groups.size()); }
        groups.push_back({hash.empty() ? 0 : plan.references.at(hash).weight, {i}});
    }
    for (Group& group : groups) { group.split(plan, 1); }
    return groups;
}

// The group with the dearest piece of those that can be split further.
Group* next_to_split(std::vector<Group>& groups, std::size_t parts) {
    Group* next = nullptr;
    for (Group& group : groups) {
        const bool can_be_split = group.pieces.size() < std::min(parts, group.cells.size());
        if (can_be_split && (next == nullptr || group.dearest() > next->dearest())) { next = &group; }
    }
    return next;
}

std::vector<double> costs_of_pieces(const std::vector<Group>& groups) {
    std::vector<double> costs;
    for (const Group& group : groups) {
        for (const Piece& piece : group.pieces) { costs.push_back(piece.cost); }
    }
    return costs;
}

// The parts of cells, from those of pieces.
std::vector<std::size_t> parts_of_cells(const std::vector<Group>& groups, const Balance& balanced, std::size_t cells) {
    std::vector<std::size_t> parts(cells);
    std::size_t number = 0;
    for (const Group& group : groups) {
        for (const Piece& piece : group.pieces) {
            for (const std::size_t cell : piece.cells) { parts[cell] = balanced.bins[number] + 1; }
            ++number;
        }
    }
    return parts;
}

}  // namespace

// At first the cells of each reference stay together. Then they are split, the dearest first, for as long as parts
// might become cheaper; what makes the dearest part cheapest is kept, and of such the one with the cheapest next part.
std::vector<std::size_t> deal(const Plan& plan, std::size_t asked) {
    const std::size_t parts = std::max<std::size_t>(1, std::min(asked, plan.cells.size()));  // the others stay empty
    if (parts == 1) { return std::vector<std::size_t>(plan.cells.size(), 1); }
    std::vector<Group> groups = groups_of(plan);
    Balance best = balance(costs_of_pieces(groups), parts);
    std::vector<std::size_t> dealt = parts_of_cells(groups, best, plan.cells.size());
    while (Group* group = next_to_split(groups, parts)) {
        const std::size_t pieces = group->pieces.size() + std::max<std::size_t>(1, group->pieces.size() / 2);
        group->split(plan, std::min({pieces, parts, group->cells.size()}));
        const std::vector<double> costs = costs_of_pieces(groups);
        const double mean = std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(parts);
        if (mean >= best.costs.front()) { break; }
        Balance balanced = balance(costs, parts);
        if (balanced.costs >= best.costs) { continue; }
        best = std::move(balanced);
        dealt = parts_of_cells(groups, best, plan.cells.size());
    }
    return dealt;
}

}  // namespace kreisel
