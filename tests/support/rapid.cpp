// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/rapid.hpp"

#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>

#include <cstdlib>
#include <sstream>

namespace rapid {

std::string counterexample(const std::string& name, int count, int cases, const Property& property) {
    using namespace rc;
    constexpr int one = 1 << 20;
    const auto number = gen::map(gen::inRange(-one, one + 1), [](int n) { return static_cast<double>(n) / one; });
    // The nominal size from the first case on: small sizes would draw from the middle of the range only.
    const auto numbers =
        gen::resize(kNominalSize, gen::container<std::vector<double>>(static_cast<std::size_t>(count), number));
    setenv("RC_PARAMS", "seed=20240229", 1);  // the library announces the seed of its configuration, used or not
    detail::TestParams params;
    params.seed = 20240229;
    params.maxSuccess = cases;
    detail::TestMetadata metadata;
    metadata.id = metadata.description = name;
    detail::TestListenerAdapter silent;  // the default one reads the environment and writes to the terminal
    const auto result =
        detail::checkProperty(detail::toProperty([&] { RC_ASSERT(property(*numbers)); }), metadata, params, silent);
    if (result.is<detail::SuccessResult>()) return "";
    std::ostringstream report;
    detail::printResultMessage(result, report);
    return report.str();
}

}  // namespace rapid
