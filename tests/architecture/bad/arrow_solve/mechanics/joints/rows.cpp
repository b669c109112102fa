// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/rank.hpp"
