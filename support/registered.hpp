// SPDX-License-Identifier: BSD-3-Clause
//
// The entries of one kind (methods, problems, figures ...), each recorded by a static object in its own file.
#pragma once

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace kreisel {

/// Recording only stores, since it happens before main; what can throw is left to the first use, when all entries are
/// there. An entry has a name, or a description with one, and may have a `place`, which goes before the name in lists.
template <class Entry>
class Registered {
  public:
    static void add(Entry entry) { recorded().push_back(std::move(entry)); }

    /// By place, then by name: the order in which files are linked does not show. Throws std::logic_error if two have
    /// one name.
    static const std::vector<Entry>& all() {
        static const std::vector<Entry> sorted = [] {
            std::vector<Entry> entries = recorded();
            std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
                return std::forward_as_tuple(place_of(a), name_of(a)) < std::forward_as_tuple(place_of(b), name_of(b));
            });
            std::set<std::string> names;
            for (const Entry& entry : entries)
                if (!names.insert(name_of(entry)).second)
                    throw std::logic_error("two entries are named \"" + name_of(entry) + "\"");
            return entries;
        }();
        return sorted;
    }

    /// Null where there is none of that name.
    static const Entry* find(const std::string& name) {
        for (const Entry& entry : all())
            if (name_of(entry) == name) return &entry;
        return nullptr;
    }

    /// `kind` is for the message. Throws std::out_of_range for an unknown name.
    static const Entry& named(const std::string& name, const char* kind) {
        if (const Entry* entry = find(name)) return *entry;
        throw std::out_of_range(std::string("no ") + kind + " \"" + name + "\"");
    }

  private:
    static std::vector<Entry>& recorded() {
        static std::vector<Entry> entries;
        return entries;
    }
    static const auto& name_of(const Entry& entry) {
        if constexpr (requires { entry.description; })
            return entry.description.name;
        else
            return entry.name;
    }
    static int place_of(const Entry& entry) {
        if constexpr (requires { entry.place; })
            return entry.place;
        else
            return 0;
    }
};

}  // namespace kreisel
