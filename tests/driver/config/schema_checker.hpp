// SPDX-License-Identifier: BSD-3-Clause
//
// Judges configs only by the JSON Schema.
#pragma once

#include <nlohmann/json.hpp>
#include <utility>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "driver/config/schema.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// With 2.0 as 2, which is an integer to draft-07 and not to valijson.
inline nlohmann::json with_plain_integers(nlohmann::json value) {
    if (value.is_structured()) {
        for (nlohmann::json& part : value) { part = with_plain_integers(std::move(part)); }
    }
    const auto whole = whole_number(value);
    return whole ? nlohmann::json(*whole) : value;
}

class SchemaChecker {
  public:
    explicit SchemaChecker(const Catalogue& catalogue)
        : SchemaChecker(nlohmann::json::parse(config_schema(catalogue).dump())) {}
    explicit SchemaChecker(nlohmann::json text) : text_(std::move(text)) {
        valijson::SchemaParser(valijson::SchemaParser::kDraft7)
            .populateSchema(valijson::adapters::NlohmannJsonAdapter(text_), schema_);
    }
    bool accepts(const nlohmann::json& written) {
        const nlohmann::json config = with_plain_integers(written);
        valijson::Validator validator(valijson::Validator::kStrongTypes);
        return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(config), nullptr);
    }

  private:
    nlohmann::json text_;
    valijson::Schema schema_;
};

}  // namespace kreisel
