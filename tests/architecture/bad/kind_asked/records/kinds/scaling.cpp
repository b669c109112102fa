// SPDX-License-Identifier: BSD-3-Clause
KREISEL_EXPERIMENT({.name = "scaling", .timed = true, .figure = "scaling"});
