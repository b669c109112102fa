// SPDX-License-Identifier: BSD-3-Clause
#include "tableau.hpp"
