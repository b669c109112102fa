// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers by name, as the metrics of a cell: rows with the same names share them, and hold eight bytes a number.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "records/rows/shared.hpp"

namespace kreisel {

/// Reads like a std::map<std::string, double>, in ascending order of the names.
class NamedNumbers {
  public:
    using Names = std::vector<std::string>;

    struct Entry {
        const std::string& first;
        double second;
    };

    class Iterator {
      public:
        struct Pointer {
            Entry entry;
            const Entry* operator->() const { return &entry; }
        };
        using iterator_category = std::input_iterator_tag;
        using value_type = Entry;
        using difference_type = std::ptrdiff_t;
        using pointer = Pointer;
        using reference = Entry;

        Iterator(const NamedNumbers* of, std::size_t place) : of_(of), place_(place) {}
        Entry operator*() const { return {(*of_->names_)[place_], of_->values_[place_]}; }
        Pointer operator->() const { return {**this}; }
        Iterator& operator++() {
            ++place_;
            return *this;
        }
        bool operator==(const Iterator& other) const { return place_ == other.place_; }

      private:
        const NamedNumbers* of_;
        std::size_t place_;
    };

    NamedNumbers() = default;
    NamedNumbers(const std::map<std::string, double>& numbers);  // NOLINT: it stands for the map
    NamedNumbers(std::initializer_list<std::pair<const std::string, double>> numbers);

    Iterator begin() const { return {this, 0}; }
    Iterator end() const { return {this, values_.size()}; }
    Iterator find(const std::string& name) const;
    bool contains(const std::string& name) const { return find(name) != end(); }
    bool empty() const { return values_.empty(); }
    /// Throws std::out_of_range where there is none.
    double at(const std::string& name) const;

    /// A new one is 0.
    double& operator[](const std::string& name);
    void erase(const std::string& name);
    void clear() { *this = {}; }

    /// Holds the names together with all that have come to this pool.
    void share_names(Pool<Names>& pool) { pool.share(names_); }

    friend bool operator==(const NamedNumbers& a, const NamedNumbers& b) = default;

  private:
    Shared<Names> names_;         // ascending
    std::vector<double> values_;  // in their order
};

}  // namespace kreisel
