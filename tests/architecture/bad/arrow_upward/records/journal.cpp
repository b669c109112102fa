// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/plan.hpp"
