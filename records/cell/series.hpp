// SPDX-License-Identifier: BSD-3-Clause
//
// The problems that one entry of a config makes: each combination of the values that are listed for its parameters. A
// value is kept once, and a problem is made of them where it is wanted, so that a million values take little memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/engine.hpp"
#include "records/json/model.hpp"

namespace kreisel {

/// A parameter of which several values are listed.
class VaryingParameter {
  public:
    /// `axis`: the number of the axis along which it varies; `values`: one for each place of the axis.
    VaryingParameter(std::string name, std::size_t axis, std::vector<ParameterValue> values);

    const std::string& name() const { return name_; }
    std::size_t axis() const { return axis_; }
    bool holds_numbers() const { return !numbers_.empty(); }
    ParameterValue value(std::size_t place) const;
    std::string text(std::size_t place) const;
    /// How many of the values differ, and which of these stands at a place, from 1 in order of first appearance.
    std::size_t distinct() const { return distinct_; }
    std::size_t rank(std::size_t place) const { return ranks_.empty() ? place + 1 : ranks_[place]; }
    /// The text of a value in labels: as it is, or where that is long which of the values it is, from #1.
    std::string label(std::size_t place) const;

  private:
    std::string name_;
    std::size_t axis_;
    std::vector<double> numbers_;         // all values, or none of them
    std::vector<ParameterValue> values_;  // the others
    std::vector<std::uint32_t> ranks_;    // empty: all differ
    std::size_t distinct_ = 0;
};

class ProblemSeries {
  public:
    /// What all have in common, and how many places each axis has.
    struct Common {
        std::string problem;
        std::string label;           ///< as written
        std::string pointer;         ///< position in the config
        ParameterValues parameters;  ///< complete; those that vary have any value
        std::vector<std::size_t> axes = {};
        Shapes shapes = {};
    };
    /// `varying` in the order of the problem's description. Axes are crossed, the last varies fastest.
    explicit ProblemSeries(Common common, std::vector<VaryingParameter> varying = {});

    const std::string& problem() const { return common_.problem; }
    const std::string& label() const { return common_.label; }
    const std::string& pointer() const { return common_.pointer; }
    const ParameterValues& common_parameters() const { return common_.parameters; }
    /// Those of bodies, which drawings need; no part of the parameters.
    const Shapes& shapes() const { return common_.shapes; }
    const std::vector<VaryingParameter>& varying() const { return varying_; }
    /// How many there are, and how many places an axis has.
    std::size_t size() const { return size_; }
    std::size_t places(std::size_t axis) const { return common_.axes[axis]; }

    /// Of the problem at a point, from 0: all its parameters, the same as JSON, and its label.
    ParameterValues parameters(std::size_t point) const;
    std::string parameters_text(std::size_t point) const;
    std::string label(std::size_t point) const;
    /// The place on an axis.
    std::size_t place(std::size_t point, std::size_t axis) const;

  private:
    std::optional<std::size_t> index_of(const std::string& name) const;

    Common common_;
    std::vector<VaryingParameter> varying_;
    std::vector<std::size_t> strides_;  // of the axes
    std::size_t size_ = 1;
    struct Text {
        std::string json;                         // "name":value, or "name": of one that varies
        std::optional<std::size_t> varying = {};  // which
    };
    std::vector<Text> texts_;
};

/// One problem of a config.
class ProblemPoint {
  public:
    ProblemPoint(std::shared_ptr<const ProblemSeries> series, std::size_t point)
        : series_(std::move(series)), point_(point) {}

    const std::string& name() const { return series_->problem(); }
    /// The label as written; problems of one entry share it.
    const std::string& series_label() const { return series_->label(); }
    /// Its own: that, and the values of parameters that vary.
    std::string label() const { return series_->label(point_); }
    ParameterValues parameters() const { return series_->parameters(point_); }
    std::string parameters_text() const { return series_->parameters_text(point_); }
    /// Position in the config, of it and of a parameter: below "parameters" where the config writes them.
    const std::string& pointer() const { return series_->pointer(); }
    std::string parameter_pointer(const std::string& path) const { return pointer() + "/parameters" + path; }

    const std::shared_ptr<const ProblemSeries>& series() const { return series_; }
    std::size_t point() const { return point_; }
    bool operator==(const ProblemPoint&) const = default;

  private:
    std::shared_ptr<const ProblemSeries> series_;
    std::size_t point_;
};

}  // namespace kreisel
