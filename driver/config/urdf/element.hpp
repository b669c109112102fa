// SPDX-License-Identifier: BSD-3-Clause
//
// Elements of an XML file with their places. Internal to the reader of URDF.
#pragma once

#include <tinyxml2.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace kreisel::urdf {

/// What is wrong with a file, and what of it is left out.
class Complaints {
  public:
    explicit Complaints(std::string file) : file_(std::move(file)) {}
    void add(int line, const std::string& text);
    /// `text` without a place, once.
    void remark(const std::string& text);
    /// Throws Refusal with all that was added; does nothing if that is nothing.
    void raise() const;
    const std::vector<std::string>& remarks() const { return remarks_; }
    const std::string& file() const { return file_; }

  private:
    std::string file_;
    std::vector<std::string> errors_, remarks_;
};

class Element {
  public:
    Element(const tinyxml2::XMLElement& element, Complaints& complaints) : element_(&element), sink_(&complaints) {}

    std::string tag() const { return element_->Name(); }
    int line() const { return element_->GetLineNum(); }
    /// `<joint "elbow">`, or `<origin>`.
    std::string shown() const;
    void error(const std::string& text) const { sink_->add(line(), shown() + ": " + text); }
    Complaints& complaints() const { return *sink_; }

    std::vector<Element> children() const;
    std::optional<Element> child(const char* tag) const;
    /// An error where there is none.
    std::optional<Element> require(const char* tag) const;

    bool has(const char* attribute) const { return element_->Attribute(attribute) != nullptr; }
    /// Empty with an error where there is none.
    std::string text(const char* attribute) const;
    /// `otherwise` where there is none; an error where it is no number.
    double number(const char* attribute, double otherwise) const;
    double required_number(const char* attribute) const;
    std::array<double, 3> vector(const char* attribute, std::array<double, 3> otherwise) const;

  private:
    std::vector<double> numbers(const char* attribute) const;

    const tinyxml2::XMLElement* element_;
    Complaints* sink_;
};

}  // namespace kreisel::urdf
