// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// For quad, of a method whose library computes in double: it is known there, and declines.
inline Factory double_only(const std::string& name) {
    Factory factory;
    factory.why_not = [name](const OptionValues&) { return name + " computes in double precision only"; };
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
