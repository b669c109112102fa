// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/schema/keys.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace kreisel::schema {

Schema of_kind(const CountKind& kind) { return integer(kind.least, kind.most); }

Schema of_kind(const PositiveKind& kind) {
    Schema schema = positive();
    if (!kind.below) { return schema; }
    schema.erase("maximum");
    schema["exclusiveMaximum"] = *kind.below;
    return schema;
}

Schema of_kind(const TextKind& kind) { return text(kind.longest); }

Schema of_kind(const NameKind& kind) { return choice(kind.names); }

Schema of_kind(const FlagKind& /*kind*/) { return {{"type", "boolean"}}; }

Schema object_of(const ConfigKeys& keys, const Schema& values) {
    Schema properties = Schema::object();
    std::vector<std::string> required;
    for (const ConfigKey& key : keys) {
        properties[key.name] = values.at(key.name);
        properties[key.name]["description"] = key.meaning;
        if (!key.missing.empty()) { required.push_back(key.name); }
    }
    if (properties.size() != values.size()) { throw std::logic_error("the schema has a key that no config has"); }
    return object(properties, required);
}

}  // namespace kreisel::schema
