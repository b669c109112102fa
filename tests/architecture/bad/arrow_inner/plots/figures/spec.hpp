// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plots/figures/kinds/curves.hpp"
