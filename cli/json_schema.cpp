// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "json_schema.h"

#include <algorithm>
#include <string>

namespace meniscus::cli {

ordered_json or_null(ordered_json rules) {
    ordered_json& type = rules["type"];
    if (type.is_string()) type = ordered_json::array({type, "null"});
    return rules;
}

ordered_json SchemaVisitor::rules() const {
    ordered_json required = ordered_json::array();
    for (const auto& property : properties_.items()) required.push_back(property.key());
    return {{"type", "object"}, {"required", required}, {"additionalProperties", false}, {"properties", properties_}};
}

void SchemaVisitor::add(const Quantity& quantity, ordered_json rules) {
    const std::string unit = quantity.unit;
    ordered_json& property = properties_[quantity.name];
    property["description"] = quantity.meaning + (unit.empty() ? "" : " (" + unit + ")");
    property.update(rules);
}

ordered_json either(const ordered_json& one, const ordered_json& other) {
    ordered_json both = one;
    both["properties"].update(other["properties"]);
    both["required"] = ordered_json::array();
    for (const ordered_json& key : one["required"])
        if (other["properties"].contains(key.get<std::string>())) both["required"].push_back(key);
    return both;
}

ordered_json schema_document(const char* title, const char* description) {
    return {
        {"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}, {"description", description}};
}

}  // namespace meniscus::cli
