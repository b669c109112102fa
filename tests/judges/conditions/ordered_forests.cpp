// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/conditions/ordered_forests.hpp"

#include <algorithm>

namespace kreisel::orders {

OrderedForests::OrderedForests(int order) {
    add({}, 0);
    for (int n = 1; n <= order; ++n) {
        const std::size_t smaller = words_.size();
        for (std::size_t head = 0; head < smaller; ++head) {
            const int rest = n - nodes_[head] - 1;  // nodes of the branches of the last tree
            for (Tree tree = 0; tree < smaller; ++tree) {
                if (nodes_[tree] != rest) continue;
                Word word = words_[head];
                word.push_back(tree);
                add(word, n);
            }
        }
    }
}

void OrderedForests::add(const Word& word, int nodes) {
    index_[word] = words_.size();
    words_.push_back(word);
    nodes_.push_back(nodes);
    std::vector<Split> splits;
    for (auto cut = word.begin();; ++cut) {
        splits.push_back({index_.at(Word(word.begin(), cut)), Word(cut, word.end())});
        if (cut == word.end()) break;
    }
    splits_.push_back(splits);
}

std::vector<std::size_t> OrderedForests::of_order(int n) const {
    std::vector<std::size_t> forests;
    for (std::size_t w = 0; w < size(); ++w)
        if (nodes_[w] == n) forests.push_back(w);
    return forests;
}

std::vector<std::size_t> OrderedForests::lyndon(int n) const {
    const auto is_lyndon = [](const Word& word) {  // smaller than each of its proper suffixes
        for (auto suffix = word.begin() + 1; suffix < word.end(); ++suffix)
            if (!std::lexicographical_compare(word.begin(), word.end(), suffix, word.end())) return false;
        return true;
    };
    auto forests = of_order(n);
    std::erase_if(forests, [&](std::size_t w) { return !is_lyndon(words_[w]); });
    return forests;
}

}  // namespace kreisel::orders
