// SPDX-License-Identifier: BSD-3-Clause
//
// Elements of an XML file with their places. Internal to the reader of URDF.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace kreisel::urdf {

/// What is wrong with a file, and what of it is left out.
class Complaints {
  public:
    Complaints(std::string file, const std::string& text);
    /// The line of the character at `offset` of the text.
    int line_at(std::ptrdiff_t offset) const;
    void add(int line, const std::string& text);
    /// `text` without a place, once.
    void remark(const std::string& text);
    /// Throws Refusal with all that was added; does nothing if that is nothing.
    void raise() const;
    const std::vector<std::string>& remarks() const { return remarks_; }
    const std::string& file() const { return file_; }

  private:
    std::string file_;
    std::vector<std::ptrdiff_t> ends_;  // of the lines
    std::vector<std::string> errors_, remarks_;
};

class Element {
  public:
    Element(const pugi::xml_node& element, Complaints& complaints) : element_(element), sink_(&complaints) {}

    std::string tag() const { return element_.name(); }
    int line() const { return sink_->line_at(element_.offset_debug()); }
    /// `<joint "elbow">`, or `<origin>`.
    std::string shown() const;
    void error(const std::string& text) const { sink_->add(line(), shown() + ": " + text); }
    Complaints& complaints() const { return *sink_; }

    std::vector<Element> children() const;
    std::optional<Element> child(const char* tag) const;
    /// An error where there is none.
    std::optional<Element> require(const char* tag) const;

    bool has(const char* attribute) const { return !element_.attribute(attribute).empty(); }
    /// Empty with an error where there is none.
    std::string text(const char* attribute) const;
    /// `otherwise` where there is none; an error where it is no number.
    double number(const char* attribute, double otherwise) const;
    double required_number(const char* attribute) const;
    std::array<double, 3> vector(const char* attribute, std::array<double, 3> otherwise) const;

  private:
    std::string value(const char* attribute) const { return element_.attribute(attribute).value(); }
    /// Nothing, with an error, where a word is no number.
    std::optional<std::vector<double>> numbers(const char* attribute) const;

    pugi::xml_node element_;
    Complaints* sink_;
};

}  // namespace kreisel::urdf
