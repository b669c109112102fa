// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/force_type.hpp"

#include <utility>

#include "support/registered.hpp"

namespace kreisel {

const std::vector<ForceKind>& force_kinds() { return Registered<ForceKind>::all(); }

const ForceKind& force_kind(const std::string& name) { return Registered<ForceKind>::named(name, "force"); }

ForceRegistration::ForceRegistration(ElementType keys, ForceTraits traits) {
    Registered<ForceKind>::add({std::move(keys), traits});
}

}  // namespace kreisel
