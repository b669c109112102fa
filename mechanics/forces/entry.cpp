// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/forces/entry.hpp"

#include "mechanics/model/data.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

void ForceEntry::refuse(const std::string& key, const std::string& what) const {
    throw ParameterError(path + "/" + key, who + ": " + what);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
