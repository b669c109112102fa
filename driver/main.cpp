// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/cli.hpp"
#include "kreisel_build.hpp"

int main(int argc, char** argv) {
    using namespace kreisel;
    if constexpr (build::has_binary128) {
        return kreisel_main(argc, argv, engine_binary64(), engine_binary128());
    } else {
        return kreisel_main(argc, argv, engine_binary64());
    }
}
