// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "records/json/writer.hpp"

namespace kreisel {

namespace {

constexpr std::size_t longest_label = 60;  // of a value in the label of a problem

std::vector<double> numbers_of(const std::vector<ParameterValue>& values) {
    std::vector<double> numbers;
    for (const ParameterValue& value : values) {
        const double* number = std::get_if<double>(&value);
        if (number == nullptr) { return {}; }
        numbers.push_back(*number);
    }
    return numbers;
}

// Zeros of both signs are different texts, and not told apart here.
bool surely_differ(std::vector<double> numbers) {
    std::sort(numbers.begin(), numbers.end());
    return std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end();
}

}  // namespace

VaryingParameter::VaryingParameter(std::string name, std::size_t axis, std::vector<ParameterValue> values)
    : name_(std::move(name)),
      axis_(axis),
      numbers_(numbers_of(values)),
      values_(numbers_.empty() ? std::move(values) : std::vector<ParameterValue>()),
      distinct_(std::max(numbers_.size(), values_.size())) {
    if (!numbers_.empty() && surely_differ(numbers_)) { return; }
    std::unordered_map<std::string, std::uint32_t> known;
    std::vector<std::uint32_t> ranks;
    for (std::size_t place = 0; place < distinct_; ++place) {
        const auto next = static_cast<std::uint32_t>(known.size() + 1);
        ranks.push_back(known.emplace(text(place), next).first->second);
    }
    if (known.size() == distinct_) { return; }
    distinct_ = known.size();
    ranks_ = std::move(ranks);
}

ParameterValue VaryingParameter::value(std::size_t place) const {
    return holds_numbers() ? ParameterValue(numbers_[place]) : values_[place];
}

std::string VaryingParameter::text(std::size_t place) const {
    return holds_numbers() ? json_number(numbers_[place]) : json_value(values_[place]);
}

std::string VaryingParameter::label(std::size_t place) const {
    std::string as_it_is = text(place);
    if (as_it_is.size() <= longest_label) { return as_it_is; }
    return fmt::format("#{}", rank(place));
}

ProblemSeries::ProblemSeries(Common common, std::vector<VaryingParameter> varying)
    : common_(std::move(common)), varying_(std::move(varying)), strides_(common_.axes.size()) {
    for (std::size_t axis = strides_.size(); axis-- > 0;) {
        strides_[axis] = size_;
        size_ *= common_.axes[axis];
    }
    for (const auto& [name, value] : common_.parameters) {
        const std::string head = json_text(name) + ":";
        const auto place = index_of(name);
        texts_.push_back({place ? head : head + json_value(value), place});
    }
}

std::optional<std::size_t> ProblemSeries::index_of(const std::string& name) const {
    for (std::size_t i = 0; i < varying_.size(); ++i) {
        if (varying_[i].name() == name) { return i; }
    }
    return std::nullopt;
}

std::size_t ProblemSeries::place(std::size_t point, std::size_t axis) const {
    return point / strides_[axis] % common_.axes[axis];
}

ParameterValues ProblemSeries::parameters(std::size_t point) const {
    ParameterValues values = common_.parameters;
    for (const VaryingParameter& one : varying_) { values[one.name()] = one.value(place(point, one.axis())); }
    return values;
}

std::string ProblemSeries::parameters_text(std::size_t point) const {
    std::string text = "{";
    for (const Text& one : texts_) {
        if (text.size() > 1) { text += ','; }
        text += one.json;
        if (!one.varying) { continue; }
        const VaryingParameter& varying = varying_[*one.varying];
        text += varying.text(place(point, varying.axis()));
    }
    text += '}';
    return text;
}

std::string ProblemSeries::label(std::size_t point) const {
    std::string text = common_.label;
    for (const VaryingParameter& one : varying_) {
        if (one.distinct() == 1) { continue; }
        text.append(", ").append(one.name()).append(" = ").append(one.label(place(point, one.axis())));
    }
    return text;
}

}  // namespace kreisel
