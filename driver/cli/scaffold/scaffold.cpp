// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/scaffold/scaffold.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "driver/cli/scaffold/texts.hpp"
#include "driver/config/shipped.hpp"
#include "records/json/diagnostics.hpp"
#include "support/errors.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

constexpr std::size_t longest_name = 20;  // with it no line is longer than 120 columns
constexpr const char *family_prefix = "method.", *name_mark = "@NAME@", *indent_mark = "@>@";
constexpr const char* a_word = "1 to 20 of a-z, 0-9 and _, beginning with a letter";

[[noreturn]] void refuse(const std::string& expected, const std::string& got, const std::string& nearest = "") {
    throw UsageError(fmt::format("expected {}, got {}{}", expected, in_quotes(got),
                                 nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?"));
}

// What a file and an identifier of C++ may be called.
bool is_word(const std::string& name) {
    const bool letters = name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
    return letters && !name.empty() && name.size() <= longest_name && name[0] >= 'a' && name[0] <= 'z';
}

std::string with_name(std::string text, const std::string& name) {
    const std::string mark = name_mark;
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + name.size())) {
        text.replace(at, mark.size(), name);
    }
    return text;
}

// Lines that begin with the mark are set behind the brace that opened last above them, wherever the name moved it to.
std::string with_indents(const std::string& text) {
    std::string result;
    std::size_t column = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin) + 1;
        const std::string line = text.substr(begin, end - begin);
        if (line.starts_with(indent_mark)) {
            result += std::string(column, ' ') + line.substr(std::string_view(indent_mark).size());
        } else {
            result += line;
            column = line.rfind('{') + 1;
        }
        begin = end;
    }
    return result;
}

template <class Description>
void require_new(const std::string& what, const std::string& name, const std::vector<Description>& known) {
    if (find_named(known, name) != nullptr) {
        throw UsageError(fmt::format("expected the name of a new {}, got {}, which there is (kreisel info {})", what,
                                     in_quotes(name), name));
    }
}

Scaffold method_scaffold(const std::string& name, const Catalogue& catalogue) {
    const std::size_t slash = name.find('/');
    const std::vector<std::string> families = scaffold_families();
    if (slash == std::string::npos) {
        refuse("a name FAMILY/SCHEME, where FAMILY is one of " + listed(families), name);
    }
    const std::string family = name.substr(0, slash), scheme = name.substr(slash + 1);
    if (std::find(families.begin(), families.end(), family) == families.end()) {
        refuse("one of the families that are data, " + listed(families) +
                   " (of others see \"Adding a method\" in CONTRIBUTING.md)",
               family, nearest_name(family, families));
    }
    if (!is_word(scheme)) { refuse(fmt::format("a name {}/SCHEME, where SCHEME is {}", family, a_word), name); }
    require_new("method", name, catalogue.methods);
    return {fmt::format("methods/{}/{}.cpp", family, scheme),
            with_indents(with_name(scaffold_texts().at(family_prefix + family), scheme))};
}

Scaffold problem_scaffold(const std::string& name, const Catalogue& catalogue) {
    if (!is_word(name)) { refuse(std::string("the name of a problem: ") + a_word, name); }
    require_new("problem", name, catalogue.problems);
    return {fmt::format("problems/{}.cpp", name), with_name(scaffold_texts().at("problem"), name)};
}

Scaffold experiment_scaffold(const std::string& name) {
    if (!is_word(name)) { refuse(std::string("the name of an experiment: ") + a_word, name); }
    const std::filesystem::path shipped = shipped_folder();
    if (!shipped.empty() && configs_below(shipped).contains(name)) {
        throw UsageError(fmt::format("expected the name of a new experiment, got {}, which there is: {}",
                                     in_quotes(name), configs_below(shipped).at(name).string()));
    }
    return {name + ".json", with_name(scaffold_texts().at("experiment"), name)};
}

}  // namespace

const std::vector<std::string>& scaffold_kinds() {
    static const std::vector<std::string> kinds = {"method", "problem", "experiment"};
    return kinds;
}

std::vector<std::string> scaffold_families() {
    std::vector<std::string> families;
    for (const auto& [name, text] : scaffold_texts()) {
        if (name.starts_with(family_prefix)) {
            families.push_back(name.substr(std::string_view(family_prefix).size()));
        }
    }
    return families;
}

Scaffold scaffold_of(const std::string& kind, const std::string& name, const Catalogue& catalogue) {
    if (kind == "method") { return method_scaffold(name, catalogue); }
    if (kind == "problem") { return problem_scaffold(name, catalogue); }
    if (kind == "experiment") { return experiment_scaffold(name); }
    refuse("one of " + listed(scaffold_kinds()), kind, nearest_name(kind, scaffold_kinds()));
}

}  // namespace kreisel
