// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/readers.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "driver/config/urdf/mechanism.hpp"
#include "driver/plan/plan.hpp"
#include "records/cell/line.hpp"
#include "records/cell/read_table.hpp"
#include "records/json/strict.hpp"
#include "records/manifest.hpp"
#include "records/reference_store.hpp"
#include "records/sums/summed_text.hpp"
#include "support/errors.hpp"
#include "tests/driver/fake_engine.hpp"

namespace kreisel {

namespace {

/// A file in memory, for readers that take a path.
class MemoryFile {
  public:
    explicit MemoryFile(const std::string& text) : file_(::memfd_create("kreisel", MFD_CLOEXEC)) {
        if (!file_.valid() || ::write(file_.number(), text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
            throw std::logic_error("no file in memory");
        }
    }
    std::string path() const { return "/proc/self/fd/" + std::to_string(file_.number()); }

  private:
    Descriptor file_;
};

template <class Reader>
Reading reading(const Reader& reader) {
    try {
        reader();
    } catch (const UsageError&) { return Reading::refused; } catch (const FileError&) {
        return Reading::refused;
    }
    return Reading::taken;
}

void plan(const Document& config) {
    static const FakeEngine engine;
    plan_of(config, {engine, engine});
}

/// Without the files that a config may name, which are anything on this machine.
Reading read_config(const std::string& text) {
    return reading([&] { plan(parse_document("config", text)); });
}

/// As the parameters of a problem.
Reading read_mechanism(const std::string& text) {
    return reading([&] {
        Document config = parse_document("config", R"({"name": "m", "kind": "drift", "problems": [{"name": "multibody",
            "parameters": {}}], "methods": ["rkmk/rk4"], "time": {"end": 1, "steps": 2}})");
        config.value["problems"][0]["parameters"] = parse_document("mechanism", text).value;
        config.text = config.value.dump();
        plan(config);
    });
}

Reading read_robot(const std::string& text) {
    const MemoryFile file(text);
    return reading([&] { urdf::read_mechanism(file.path(), {}); });
}

/// Both as it stands and under a sum that holds: no text of chance has one.
Reading read_journalled(const std::string& text) {
    const auto is_taken = [](const std::string& line) {
        journalled_cell(line);
        return read_journal_line(line).has_value();
    };
    const bool taken = is_taken(text), summed = is_taken(with_sum(text));
    return taken || summed ? Reading::taken : Reading::refused;
}

/// A reference is of a plan.
const PlannedReference& some_reference() {
    static const FakeEngine engine;
    static const Plan plan =
        plan_of(parse_document("config", R"({"name": "r", "kind": "convergence", "problems": ["heavy_top"],
            "methods": ["rkmk/rk4"], "metrics": ["error.position"], "time": {"end": 1, "steps": 2}})"),
                {engine, engine});
    return plan.references.begin()->second;
}

/// As it stands, and as what follows the content that was asked for, under a sum that holds.
Reading read_stored_reference(const std::string& text) {
    const PlannedReference& planned = some_reference();
    const std::string summed = with_sum("{\"of\":" + planned.content + "," + text, {compact_sum.before, "\"}\n"});
    const bool whole = read_reference(text, planned, "").has_value(),
               completed = read_reference(summed, planned, "").has_value();
    return whole || completed ? Reading::taken : Reading::refused;
}

Reading read_kept_manifest(const std::string& text) {
    const MemoryFile plain(text), summed(with_sum(text, indented_sum));
    const auto read = [](const MemoryFile& file) { return reading([&] { read_manifest(file.path()); }); };
    const Reading first = read(plain), second = read(summed);
    return first == Reading::taken ? first : second;
}

Reading read_table(const std::string& text) {
    try {
        read_results_table(text);
    } catch (const std::invalid_argument&) { return Reading::refused; }
    return Reading::taken;
}

}  // namespace

const std::map<std::string, Reading (*)(const std::string& text)>& readers() {
    static const std::map<std::string, Reading (*)(const std::string& text)> all = {
        {"config", read_config},      {"mechanism", read_mechanism},        {"robot", read_robot},
        {"journal", read_journalled}, {"reference", read_stored_reference}, {"manifest", read_kept_manifest},
        {"table", read_table},
    };
    return all;
}

}  // namespace kreisel
