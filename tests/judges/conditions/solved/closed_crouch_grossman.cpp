// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/conditions/crouch_grossman_system.hpp"
#include "tests/judges/conditions/solved/published_crouch_grossman.hpp"

namespace kreisel::orders {

namespace {

PrintedRow decimals(const std::vector<Float100>& row) {
    PrintedRow printed;
    for (const Float100& entry : row) printed.push_back(entry.str(60, std::ios_base::fixed));
    return printed;
}

}  // namespace

/// With T = 2^(1/3); b is that of the composition of three symmetric steps, 2 b_1 = 1/(2 - T).
PublishedCrouchGrossman published_cg43() {
    const Float100 T = cbrt(Float100(2)), T2 = T * T, one = 1;
    const Float100 t1 = 1 + T + T2, t2 = T + T2, t3 = 2 * T + T2, t4 = 4 + 3 * T + 2 * T2;
    const Float100 theta = (t1 + sqrt(105 + 88 * T + 71 * T2)) / 18;
    const Float100 c3 = (4 + t3) / 6, c4 = (2 - t3) / 6;
    const Float100 a32 = t4 / 18, a42 = t1 * theta - a32, a43 = (3 + t2 - 9 * t1 * theta) / (4 + t3);
    const Float100 a53 = (3 + 2 * t2 - 9 * t1 * theta) / (10 + 8 * T + 7 * T2), a54 = -t2 / (4 + t3);
    const Float100 b1 = t1 / (2 * t2), b3 = -(1 + t3) / (6 * (2 + t2)), b4 = -one / (2 * t2);
    return {
        .method = "crouch_grossman/cg43",
        .order = 4,
        .a = {{},
              decimals({one * 3 / 2}),
              decimals({c3 - a32, a32}),
              decimals({c4 - a42 - a43, a42, a43}),
              decimals({1 - theta - a53 - a54, theta, a53, a54})},
        .b = decimals({b1, 0, b3, b4, b1}),
        .last_row = {"0.2180035838956815", "0.03358342432544368", "0.051877024484363196", "0.2611833707193039",
                     "0.09505681255977678"},
        .b_hat = {"0.2314526777098999", "-0.040478457935008656", "-0.0945230072048772", "0.03693984366110751",
                  "0.3811561150193347", "0.48545282874954365"},
    };
}

}  // namespace kreisel::orders
