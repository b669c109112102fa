// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace kreisel {

class Extrapolation {
    double value;
};

}  // namespace kreisel
