// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/cli.hpp"

int main(int argc, char** argv) {
    return kreisel::kreisel_main(argc, argv, kreisel::engine_binary64(), kreisel::engine_binary128());
}
