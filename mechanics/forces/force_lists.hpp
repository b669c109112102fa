// SPDX-License-Identifier: BSD-3-Clause
//
// Lists of forces of several types, and loops over all of them that are resolved at compile time.
#pragma once

#include <cstddef>

namespace kreisel {

/// Each of `Lists` is a struct whose only member is a vector of forces.
template <class... Lists>
struct ForceLists : Lists... {
    /// Calls f(force, i), list by list; i counts within a list.
    template <class F>
    void each(F f) const {
        (each_of(static_cast<const Lists&>(*this), f), ...);
    }
    /// Whether is(force) holds for any force, or for all.
    template <class Is>
    bool any(Is is) const {
        bool found = false;
        each([&](const auto& force, std::size_t) { found = found || is(force); });
        return found;
    }
    template <class Is>
    bool all(Is is) const {
        return !any([&](const auto& force) { return !is(force); });
    }

  private:
    template <class List, class F>
    static void each_of(const List& holder, F& f) {
        const auto& [list] = holder;
        for (std::size_t i = 0; i < list.size(); ++i) f(list[i], i);
    }
};

}  // namespace kreisel
