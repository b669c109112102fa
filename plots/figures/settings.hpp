// SPDX-License-Identifier: BSD-3-Clause
//
// What gnuplot scripts read before they draw.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "plots/figures/enhanced_text.hpp"

namespace kreisel {

/// A text of assignments.
class Settings {
  public:
    void number(const std::string& name, double value) { text_ += fmt::format("{} = {}\n", name, value); }
    void string(const std::string& name, const std::string& value) {
        text_ += fmt::format("{} = {}\n", name, gnuplot_quoted(value));
    }
    template <class Item, class Write>
    void array(const std::string& name, const std::vector<Item>& items, const Write& write) {
        std::string list;
        for (const Item& item : items) { list += (list.empty() ? "" : ",") + std::string(write(item)); }
        text_ += fmt::format("array {}[{}] = [{}]\n", name, std::max<std::size_t>(items.size(), 1),
                             items.empty() ? "0" : list);
    }
    void numbers(const std::string& name, const std::vector<double>& values) {
        array(name, values, [](double value) { return fmt::format("{}", value); });
    }
    void strings(const std::string& name, const std::vector<std::string>& values) {
        array(name, values, [](const std::string& value) { return gnuplot_quoted(value); });
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_ = "# Written by kreisel plot.\n";
};

}  // namespace kreisel
