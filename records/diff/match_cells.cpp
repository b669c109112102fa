// SPDX-License-Identifier: BSD-3-Clause
#include "records/diff/match_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace kreisel {

namespace {

using Identity = std::map<std::string, std::string>;
using Places = std::vector<std::size_t>;

bool tells_all_of(const Identity& more, const Identity& less) {
    return std::includes(more.begin(), more.end(), less.begin(), less.end());
}

std::vector<std::string> told_besides(const Identity& more, const Identity& less) {
    std::vector<std::string> names;
    for (const auto& [name, value] : more) {
        if (!less.contains(name)) { names.push_back(name); }
    }
    return names;
}

class CellMatcher {
  public:
    CellMatcher(const std::vector<RecordedCell>& a, const std::vector<RecordedCell>& b)
        : a_(a), b_(b), partner_(a.size(), none), taken_(b.size(), false) {}

    CellMatching match() {
        match_equal(true);
        match_equal(false);
        match_nested();
        CellMatching result;
        for (std::size_t i = 0; i < a_.size(); ++i) {
            if (partner_[i] == none) {
                result.only_a.push_back(i);
            } else {
                result.pairs.emplace_back(i, partner_[i]);
            }
        }
        for (std::size_t j = 0; j < b_.size(); ++j) {
            if (!taken_[j]) { result.only_b.push_back(j); }
        }
        for (const auto& [what, count] : extras_) {
            result.notes.push_back(
                fmt::format("{} {} matched although only {}", count, count == 1 ? "cell is" : "cells are", what));
        }
        return result;
    }

  private:
    static constexpr auto none = static_cast<std::size_t>(-1);

    void pair(std::size_t i, std::size_t j) {
        partner_[i] = j;
        taken_[j] = true;
    }

    void match_equal(bool with_label) {
        const auto key = [&](const RecordedCell& cell) {
            return std::pair(cell.identity, with_label ? cell.label : std::string());
        };
        std::map<std::pair<Identity, std::string>, Places> free;
        for (std::size_t j = b_.size(); j-- > 0;) {
            if (!taken_[j]) { free[key(b_[j])].push_back(j); }
        }
        for (std::size_t i = 0; i < a_.size(); ++i) {
            if (partner_[i] != none) { continue; }
            const auto found = free.find(key(a_[i]));
            if (found == free.end() || found->second.empty()) { continue; }
            pair(i, found->second.back());
            found->second.pop_back();
        }
    }

    void match_nested() {
        std::map<std::size_t, Places> of_a, of_b;
        for (std::size_t i = 0; i < a_.size(); ++i) {
            if (partner_[i] != none) { continue; }
            for (std::size_t j = 0; j < b_.size(); ++j) {
                if (taken_[j] || !one_tells_all(a_[i].identity, b_[j].identity)) { continue; }
                of_a[i].push_back(j);
                of_b[j].push_back(i);
            }
        }
        for (const auto& [i, candidates] : of_a) {
            if (candidates.size() != 1 || of_b.at(candidates.front()).size() != 1) { continue; }
            pair(i, candidates.front());
            note(a_[i].identity, b_[candidates.front()].identity);
        }
    }

    static bool one_tells_all(const Identity& one, const Identity& other) {
        return tells_all_of(one, other) || tells_all_of(other, one);
    }

    void note(const Identity& one, const Identity& other) {
        for (const std::string& name : told_besides(one, other)) { ++extras_["A tells " + name]; }
        for (const std::string& name : told_besides(other, one)) { ++extras_["B tells " + name]; }
    }

    const std::vector<RecordedCell>&a_, &b_;
    Places partner_;
    std::vector<bool> taken_;
    std::map<std::string, std::size_t> extras_;
};

}  // namespace

CellMatching match_cells(const std::vector<RecordedCell>& a, const std::vector<RecordedCell>& b) {
    return CellMatcher(a, b).match();
}

}  // namespace kreisel
