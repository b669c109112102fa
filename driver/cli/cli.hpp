// SPDX-License-Identifier: BSD-3-Clause
//
// The program.
#pragma once

#include "engine/engine.hpp"

namespace kreisel {

/// Carries out a command line and returns the exit code (errors.hpp). Throws nothing.
int kreisel_main(int argc, const char* const* argv, const Engine& binary64, const Engine& binary128);
/// The same without quad precision.
int kreisel_main(int argc, const char* const* argv, const Engine& binary64);

}  // namespace kreisel
