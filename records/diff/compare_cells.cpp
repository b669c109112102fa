// SPDX-License-Identifier: BSD-3-Clause
#include "records/diff/compare_cells.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>

#include "records/diff/match_cells.hpp"
#include "records/diff/quantity_scale.hpp"

namespace kreisel {

namespace {

using ScaleOf = std::function<double(const std::string& name, const std::string& family, double own)>;

/// The families of numbers that some cell of a folder has among its final states and metrics.
std::set<std::string> recorded_families(const std::vector<RecordedCell>& cells) {
    std::set<std::string> families;
    for (const RecordedCell& cell : cells) {
        for (const auto* part : {&cell.final_state, &cell.metrics}) {
            for (const auto& [name, quantity] : *part) { families.insert(quantity.family); }
        }
    }
    return families;
}

/// Families of numbers that no cell of the other folder has.
class OneSidedFamilies {
  public:
    OneSidedFamilies(const std::vector<RecordedCell>& a, const std::vector<RecordedCell>& b) {
        const auto of_a = recorded_families(a), of_b = recorded_families(b);
        std::set_difference(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::inserter(in_a_, in_a_.end()));
        std::set_difference(of_b.begin(), of_b.end(), of_a.begin(), of_a.end(), std::inserter(in_b_, in_b_.end()));
    }
    bool contains(const std::string& family) const { return in_a_.contains(family) || in_b_.contains(family); }
    std::vector<std::string> notes() const {
        std::vector<std::string> notes;
        for (const auto& family : in_a_) { notes.push_back(family + " is not compared: no cell of B has it"); }
        for (const auto& family : in_b_) { notes.push_back(family + " is not compared: no cell of A has it"); }
        return notes;
    }

  private:
    std::set<std::string> in_a_, in_b_;
};

/// Compares two records of one cell, part by part.
class CellComparer {
  public:
    CellComparer(const RecordedCell& a, const RecordedCell& b, std::optional<double> within)
        : a_(a), b_(b), within_(within), scales_(a, b), difference_{&a, &b, {}} {}

    CellDifference compare() {
        if (difference_.status_changed()) { return std::move(difference_); }
        compare_part(a_.final_state, b_.final_state,
                     [&](const auto&, const auto& family, double) { return scales_.of_state(family); });
        compare_part(a_.metrics, b_.metrics,
                     [&](const auto& name, const auto&, double own) { return scales_.of_metric(name, own); });
        if (!within_) {
            compare_part(a_.others, b_.others, [](const auto&, const auto&, double) { return no_scale; });
            compare_samples();
        }
        return std::move(difference_);
    }

  private:
    static constexpr double no_scale = -1;

    void compare_part(const RecordedQuantities& a, const RecordedQuantities& b, const ScaleOf& scale) {
        for (const auto& [name, quantity] : a) {
            const auto found = b.find(name);
            if (found == b.end()) {
                add({name, quantity.family, quantity.number.text(), ""});
            } else {
                compare_numbers(name, quantity, found->second, scale);
            }
        }
        for (const auto& [name, quantity] : b) {
            if (!a.contains(name)) { add({name, quantity.family, "", quantity.number.text()}); }
        }
    }

    void compare_numbers(const std::string& name, const RecordedQuantity& a, const RecordedQuantity& b,
                         const ScaleOf& scale_of) {
        const NumberDistance moved = distance(a.number, b.number);
        if (!moved.any()) { return; }
        const double own = std::max(std::fabs(a.number.value), std::fabs(b.number.value));
        const double scale = scale_of(name, a.family, own);
        // Numbers of quad runs may be too small for double, and their scale is then zero: their own size is used.
        const double of_scale = scale == no_scale ? 0 : scale > 0 ? moved.absolute / scale : moved.relative;
        if (within_ && of_scale <= *within_) { return; }
        add({name, a.family, a.number.text(), b.number.text(), moved.ulps, moved.relative, of_scale});
    }

    void compare_samples() {
        if (a_.trajectory_sum == b_.trajectory_sum) { return; }
        add({"trajectory_sum", "trajectory_sum", a_.trajectory_sum, b_.trajectory_sum});
    }

    void add(QuantityDifference difference) { difference_.quantities.push_back(std::move(difference)); }

    const RecordedCell &a_, &b_;
    std::optional<double> within_;
    QuantityScales scales_;
    CellDifference difference_;
};

}  // namespace

const QuantityDifference* CellDifference::furthest() const {
    const QuantityDifference* result = nullptr;
    for (const QuantityDifference& one : quantities) {
        if (one.ulps > 0 && (result == nullptr || one.of_scale > result->of_scale)) { result = &one; }
    }
    return result;
}

CellComparison compare_cells(const std::vector<RecordedCell>& a, const std::vector<RecordedCell>& b,
                             std::optional<double> within) {
    const CellMatching matching = match_cells(a, b);
    const OneSidedFamilies one_sided(a, b);
    CellComparison result{a.size(), b.size()};
    result.notes = matching.notes;
    for (const std::size_t i : matching.only_a) { result.only_a.push_back(&a[i]); }
    for (const std::size_t j : matching.only_b) { result.only_b.push_back(&b[j]); }
    if (within) {
        const auto notes = one_sided.notes();
        result.notes.insert(result.notes.end(), notes.begin(), notes.end());
    }
    for (const auto& [i, j] : matching.pairs) {
        CellDifference difference = CellComparer(a[i], b[j], within).compare();
        if (within) {
            std::erase_if(difference.quantities, [&](const auto& one) { return one_sided.contains(one.family); });
        }
        if (difference.status_changed() || !difference.quantities.empty()) {
            result.changed.push_back(std::move(difference));
        } else {
            ++result.same;
        }
    }
    return result;
}

}  // namespace kreisel
