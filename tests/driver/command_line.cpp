// SPDX-License-Identifier: BSD-3-Clause
#include "tests/driver/command_line.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "driver/cli/cli.hpp"
#include "records/sums/summed_text.hpp"

namespace kreisel {

namespace {

// No test may leave references of a fake engine in the user's cache.
const int no_cache = ::setenv("KREISEL_CACHE", "", 1);

// Diverts a stream into a string for as long as it lives.
class Capture {
  public:
    explicit Capture(std::ostream& stream) : stream_(stream), old_(stream.rdbuf(text_.rdbuf())) {}
    ~Capture() { stream_.rdbuf(old_); }
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;
    std::string text() const { return text_.str(); }

  private:
    std::ostream& stream_;
    std::ostringstream text_;
    std::streambuf* old_;
};

template <class Program>
ProgramResult captured(const std::vector<std::string>& words, const Program& program) {
    std::vector<const char*> arguments = {"kreisel"};
    for (const std::string& word : words) { arguments.push_back(word.c_str()); }
    const Capture out(std::cout), messages(std::cerr);
    const int code = program(static_cast<int>(arguments.size()), arguments.data());
    return {code, out.text(), messages.text()};
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& words, const Engine& engine) {
    return captured(words, [&](int argc, const char* const* argv) { return kreisel_main(argc, argv, engine, engine); });
}

ProgramResult run_program_in_double(const std::vector<std::string>& words, const Engine& engine) {
    return captured(words, [&](int argc, const char* const* argv) { return kreisel_main(argc, argv, engine); });
}

ProgramResult run_program(const std::vector<std::string>& words) { return run_program(words, FakeEngine()); }

ScratchFolder::ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "kreisel_test_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) { throw std::runtime_error("cannot make " + pattern); }
    path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;  // a folder left behind does not affect tests
    std::filesystem::remove_all(path_, ignored);
}

std::string ScratchFolder::file(const std::string& name, const std::string& text) const {
    const auto path = path_ / name;
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
}

std::string contents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::string summed_line(const std::string& line) {
    auto json = nlohmann::ordered_json::parse(line);
    json.erase("sum");
    std::string open = json.dump();
    open.pop_back();
    return with_sum(open);
}

void write_summed(const std::filesystem::path& manifest, nlohmann::ordered_json json) {
    json.erase("sum");
    const std::string text = json.dump(2);
    std::ofstream(manifest) << with_sum(std::string_view(text).substr(0, text.size() - 2), indented_sum);
}

std::string good_config() {
    return R"({
  "name": "good",
  "kind": "convergence",
  "problems": ["heavy_top"],
  "methods": ["rkmk/midpoint", {"name": "rkmk/rk4", "coordinates": ["exp", "cayley"]}],
  "projections": ["none", "position_velocity"],
  "time": {"end": 1.0, "steps": {"from": 8, "levels": 2}}
})";
}

}  // namespace kreisel
