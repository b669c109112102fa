// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// `name` and a number, different each time: for static objects, so that one file can hold several registrations.
#define KREISEL_UNIQUE_NAME(name) KREISEL_JOIN_EXPANDED(name, __COUNTER__)
#define KREISEL_JOIN_EXPANDED(name, number) KREISEL_JOIN(name, number)
#define KREISEL_JOIN(name, number) name##number
