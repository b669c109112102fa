// SPDX-License-Identifier: BSD-3-Clause
#include "engine/run.hpp"
