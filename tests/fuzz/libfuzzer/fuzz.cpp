// SPDX-License-Identifier: BSD-3-Clause
//
// One reader as libFuzzer calls it: an exception that is not a refusal, an error that a sanitizer sees, and an input
// that takes too long end the program and are kept.
#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/engine.hpp"
#include "tests/driver/fake_engine.hpp"
#include "tests/fuzz/readers.hpp"

namespace kreisel {

namespace {

/// In place of the numerical code, which no reader needs.
class ReadingEngine : public FakeEngine {
  public:
    std::vector<MetricDescription> metrics() const override {
        return {{.name = "defect.position", .unit = "m"}, {.name = "error.position", .unit = "m"}};
    }
};

}  // namespace

const Engine& engine_binary64() {
    static const ReadingEngine engine;
    return engine;
}

}  // namespace kreisel

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const auto read = kreisel::readers().at(KREISEL_FUZZED);
    read(std::string(reinterpret_cast<const char*>(bytes), size));
    return 0;
}
