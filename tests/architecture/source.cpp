// SPDX-License-Identifier: BSD-3-Clause
#include "tests/architecture/source.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace architecture {

namespace fs = std::filesystem;

std::string Source::folder() const {
    const auto slash = path.find('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
}

std::string Source::extension() const { return fs::path(path).extension().string(); }

bool Source::is_cpp() const { return extension() == ".cpp" || extension() == ".hpp"; }

int Source::line_of(std::size_t offset) const {
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

namespace {

bool word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Cursor over C++ text that copies code and blanks what is not.
class Blanker {
  public:
    explicit Blanker(const std::string& text) : text_(text), out_(text) {}

    std::string run() {
        while (at_ < text_.size()) { step(); }
        return out_;
    }

  private:
    void step() {
        if (starts("//")) {
            blank_to(line_end());
        } else if (starts("/*")) {
            blank_to(after("*/", at_ + 2));
        } else if (starts("R\"") && !word_before()) {
            blank_raw_string();
        } else if (text_[at_] == '"') {
            blank_quoted('"');
        } else if (text_[at_] == '\'' && !word_before()) {
            blank_quoted('\'');
        } else {
            ++at_;
        }
    }

    bool starts(const char* what) const { return text_.compare(at_, 2, what) == 0; }
    bool word_before() const { return at_ > 0 && word_character(text_[at_ - 1]); }
    std::size_t line_end() const { return std::min(text_.find('\n', at_), text_.size()); }
    std::size_t after(const std::string& end, std::size_t from) const {
        const auto found = text_.find(end, from);
        return found == std::string::npos ? text_.size() : found + end.size();
    }

    void blank_to(std::size_t end) {
        for (; at_ < end; ++at_) {
            if (text_[at_] != '\n') { out_[at_] = ' '; }
        }
    }

    void blank_raw_string() {
        const auto open = text_.find('(', at_);
        if (open == std::string::npos) { throw std::runtime_error("raw string without a parenthesis"); }
        blank_to(after(")" + text_.substr(at_ + 2, open - at_ - 2) + "\"", open));
    }

    void blank_quoted(char quote) {
        auto end = at_ + 1;
        while (end < text_.size() && text_[end] != quote && text_[end] != '\n') { end += text_[end] == '\\' ? 2U : 1U; }
        ++at_;
        blank_to(std::min(end, text_.size()));
        if (at_ < text_.size()) { ++at_; }
    }

    const std::string& text_;
    std::string out_;
    std::size_t at_ = 0;
};

constexpr std::array folders = {"support",    "lie",     "mechanics", "problems", "methods",     "peers",
                                "engine",     "records", "plots",     "driver",   "experiments", "tests",
                                "benchmarks", "tools",   ".ci",       "paper",    "python"};
constexpr std::array root_files = {"CMakeLists.txt", "reproduce", "check"};

bool left_out(const std::string& path) { return path.starts_with("tests/architecture/bad/"); }

void add(std::vector<Source>& tree, const fs::path& root, const fs::path& file) {
    Source source{fs::relative(file, root).generic_string(), read_text(file), ""};
    if (left_out(source.path)) { return; }
    if (source.is_cpp()) { source.code = blank_comments_and_literals(source.text); }
    tree.push_back(std::move(source));
}

}  // namespace

std::string blank_comments_and_literals(const std::string& text) { return Blanker(text).run(); }

std::string read_text(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) { throw std::runtime_error("cannot read " + file.string()); }
    return text.str();
}

std::vector<Source> load_tree(const fs::path& root) {
    std::vector<Source> tree;
    for (const auto* name : root_files) {
        if (fs::is_regular_file(root / name)) { add(tree, root, root / name); }
    }
    for (const auto* folder : folders) {
        if (!fs::is_directory(root / folder)) { continue; }
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (entry.is_regular_file()) { add(tree, root, entry.path()); }
        }
    }
    std::sort(tree.begin(), tree.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
    return tree;
}

}  // namespace architecture
