// SPDX-License-Identifier: BSD-3-Clause
//
// The five-stage Crouch-Grossman method of order 4 as printed, 16 decimals, in [jackiewicz2000].
#pragma once

#include <string>
#include <vector>

namespace kreisel::orders {

struct PrintedTableau {
    std::vector<std::vector<std::string>> a;
    std::vector<std::string> b;
};

inline PrintedTableau published_cg4a() {
    return {{{},
             {"0.8177227988124852"},
             {"0.3199876375476427", "0.0659864263556022"},
             {"0.9214417194464946", "0.4997857776773573", "-1.0969984448371582"},
             {"0.3552358559023322", "0.2390958372307326", "1.3918565724203246", "-1.1092979392113465"}},
            {"0.1370831520630755", "-0.0183698531564020", "0.7397813985370780", "-0.1907142565505889",
             "0.3322195591068374"}};
}

}  // namespace kreisel::orders
