// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <fstream>
#include <sys/wait.h>
#include "driver/plan/plan.hpp"
#include "engine/engine.hpp"
