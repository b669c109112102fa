// SPDX-License-Identifier: BSD-3-Clause
#include "records/rows/named_numbers.hpp"

#include <algorithm>
#include <stdexcept>

namespace kreisel {

namespace {

std::ptrdiff_t place_of(const std::string& name, const NamedNumbers::Names& names) {
    return std::lower_bound(names.begin(), names.end(), name) - names.begin();
}

}  // namespace

NamedNumbers::NamedNumbers(const std::map<std::string, double>& numbers) {
    Names names;
    names.reserve(numbers.size());
    values_.reserve(numbers.size());
    for (const auto& [name, value] : numbers) {
        names.push_back(name);
        values_.push_back(value);
    }
    names_ = std::move(names);
}

NamedNumbers::NamedNumbers(std::initializer_list<std::pair<const std::string, double>> numbers)
    : NamedNumbers(std::map<std::string, double>(numbers)) {}

NamedNumbers::Iterator NamedNumbers::find(const std::string& name) const {
    const auto place = static_cast<std::size_t>(place_of(name, *names_));
    return place < names_->size() && (*names_)[place] == name ? Iterator(this, place) : end();
}

double NamedNumbers::at(const std::string& name) const {
    const Iterator found = find(name);
    if (found == end()) { throw std::out_of_range("no number is called " + name); }
    return found->second;
}

double& NamedNumbers::operator[](const std::string& name) {
    const auto place = place_of(name, *names_);
    if (!contains(name)) {
        Names names = *names_;
        names.insert(names.begin() + place, name);
        names_ = std::move(names);
        values_.insert(values_.begin() + place, 0);
    }
    return values_[static_cast<std::size_t>(place)];
}

void NamedNumbers::erase(const std::string& name) {
    if (!contains(name)) { return; }
    const auto place = place_of(name, *names_);
    Names names = *names_;
    names.erase(names.begin() + place);
    names_ = std::move(names);
    values_.erase(values_.begin() + place);
}

}  // namespace kreisel
