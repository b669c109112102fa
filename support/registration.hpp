// SPDX-License-Identifier: BSD-3-Clause
//
// Static objects that record themselves. Each gets a name of its own, since several files may be compiled as one.
#pragma once

#define KREISEL_JOINED(a, b) a##b
#define KREISEL_NAMED(type, number, ...) static const type KREISEL_JOINED(kreisel_registration_, number)(__VA_ARGS__)

/// KREISEL_REGISTER(type, arguments of its constructor...).
#define KREISEL_REGISTER(type, ...) KREISEL_NAMED(type, __COUNTER__, __VA_ARGS__)
