// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace kreisel {

struct Predictor {
    double value;
};

}  // namespace kreisel
