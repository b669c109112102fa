// SPDX-License-Identifier: BSD-3-Clause
KREISEL_EXPERIMENT({.name = "drift", .metrics = {"defect.*"}, .figure = "drift"});
