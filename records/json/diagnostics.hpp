// SPDX-License-Identifier: BSD-3-Clause
//
// A JSON text with its values, and the errors found in it.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "records/json/locator.hpp"
#include "records/json/rules.hpp"
#include "support/errors.hpp"

namespace kreisel {

struct Document;

/// A file or a setting that a document was made from: the value at `pointer`, or the parts of it that `source` has.
struct Layer {
    std::string pointer;
    std::shared_ptr<const Document> source;
};

/// A parsed file that still knows its text.
struct Document {
    std::string file;
    std::string text;
    nlohmann::json value;
    std::vector<Layer> layers = {};  ///< of a document that was put together; messages point into the last that fits
    std::vector<std::string> remarks = {};  ///< of those who made it, for its reader
};

/// One error at a JSON pointer: `expected ..., got ...; did you mean "..."?`, without its empty parts, or a
/// `sentence` of the engine as it is.
struct Issue {
    std::string pointer;
    std::string expected = {};
    std::string got = {};
    std::string suggestion = {};
    Target target = Target::value;
    int occurrence = 1;
    std::string sentence = {};
    Rule rule = Rule::shape;
};

/// A document with errors in it.
struct Refusal : UsageError {
    std::vector<Issue> issues;
    Refusal(const std::string& text, std::vector<Issue> all) : UsageError(text), issues(std::move(all)) {}
};

/// The layer of a document that wrote the value at `pointer`, or the document itself.
const Document& writer_of(const Document& document, const std::string& pointer);

/// The layers of a document, with itself where it has none: for those who put other files into it.
std::vector<Layer> layers_of(const Document& document);

/// The folder that a path written at `pointer` is relative to: that of the file which holds it; of a setting, that of
/// the document.
std::filesystem::path folder_of(const Document& document, const std::string& pointer);

/// `file:line:column: /pointer: expected ..., got ...; did you mean "..."?`, on one line whatever the file holds.
std::string message(const Document& document, const Issue& issue);
std::string message_at(const Document& document, std::size_t byte, const std::string& pointer, const std::string& text);

/// `value` as a message shows it: numbers as written in the file, long texts cut, containers by their size.
std::string shown(const Document& document, const nlohmann::json& value, const std::string& pointer);

/// `text` in double quotes, control characters escaped, cut after 60 characters.
std::string in_quotes(std::string_view text);

/// Names in quotes, separated by commas.
std::string listed(const std::vector<std::string>& names);

/// Collects the errors of one document.
class Diagnostics {
  public:
    explicit Diagnostics(const Document& document) : document_(document) {}

    /// A value of the document as a message shows it.
    std::string shown_value(const std::string& pointer, const nlohmann::json& value) const {
        return shown(document_, value, pointer);
    }
    void add(Issue issue) { issues_.push_back(std::move(issue)); }
    /// The same with "got" taken from the file.
    void mismatch(const std::string& pointer, const nlohmann::json& value, const std::string& expected,
                  const std::string& suggestion = "");
    /// An error of the engine, in its own words.
    void add_sentence(const std::string& pointer, const std::string& sentence, Rule rule) {
        issues_.push_back({.pointer = pointer, .sentence = sentence, .rule = rule});
    }
    /// Something the user should know that is not an error.
    void warn(const std::string& pointer, const std::string& sentence) {
        warnings_.push_back(pointer + ": " + sentence);
    }
    const std::vector<std::string>& warnings() const { return warnings_; }
    bool empty() const { return issues_.empty(); }
    const std::vector<Issue>& issues() const { return issues_; }
    /// Throws Refusal with all messages in the order of the text; does nothing if there are none.
    void raise() const;

  private:
    const Document& document_;
    std::vector<Issue> issues_;
    std::vector<std::string> warnings_;
};

}  // namespace kreisel
