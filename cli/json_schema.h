// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The JSON schema of results: a visitor of what meniscus/describe_results.h describes.
#pragma once

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "io/json_visitor.h"
#include "meniscus/describe_results.h"
#include "meniscus/vec3.h"

namespace meniscus::cli {

ordered_json or_null(ordered_json rules);

/// The rules of a JSON schema for values of a type.
template <class T>
struct SchemaOf {
    static ordered_json rules() {
        if constexpr (std::is_convertible_v<T, std::string_view>) return {{"type", "string"}};
        if constexpr (std::is_same_v<T, bool>) return {{"type", "boolean"}};
        if constexpr (std::is_floating_point_v<T>) return {{"type", {"number", "null"}}};
        if constexpr (std::is_unsigned_v<T>) return {{"type", "integer"}, {"minimum", 0}};
        if constexpr (std::is_integral_v<T>) return {{"type", "integer"}};
    }
};
/// What is not described yet, but has its rules elsewhere in the schema.
template <>
struct SchemaOf<ordered_json> {
    static ordered_json rules() { return {{"$ref", "#/$defs/options"}}; }
};
template <class T>
ordered_json array_rules() {
    return {{"type", "array"}, {"items", SchemaOf<T>::rules()}};
}
template <class T>
struct SchemaOf<std::vector<T>> {
    static ordered_json rules() { return array_rules<T>(); }
};
template <class T, std::size_t N>
struct SchemaOf<std::array<T, N>> {
    static ordered_json rules() { return array_rules<T>(); }
};
template <>
struct SchemaOf<Vec3> {
    static ordered_json rules() { return array_rules<double>(); }
};
template <class T>
struct SchemaOf<std::map<std::string, T>> {
    static ordered_json rules() { return {{"type", "object"}, {"additionalProperties", SchemaOf<T>::rules()}}; }
};
template <class T>
struct SchemaOf<std::optional<T>> {
    static ordered_json rules() { return or_null(SchemaOf<T>::rules()); }
};
template <class... T>
struct SchemaOf<std::variant<T...>> {
    static ordered_json rules() { return {{"anyOf", ordered_json::array({SchemaOf<T>::rules()...})}}; }
};

/// Collects the rules for the object that holds a result.
class SchemaVisitor {
public:
    template <class T>
    void operator()(const Quantity& quantity, const T&) {
        add(quantity, SchemaOf<std::decay_t<T>>::rules());
    }
    template <class T, std::size_t N>
    void operator()(const Quantity& quantity, T, const Words<T, N>& words) {
        ordered_json list = ordered_json::array();
        for (const auto& word : words) list.push_back(word.first);
        add(quantity, {{"enum", list}});
    }
    template <class Inside>
    void block(const Quantity& quantity, const Inside& inside) {
        SchemaVisitor inner;
        inside(inner);
        add(quantity, inner.rules());
    }
    template <class Maybe, class Inside>
    void optional_block(const Quantity& quantity, const Maybe&, const Inside& inside) {
        add(quantity, or_null(rules_of_element<decltype(*std::declval<Maybe>())>(inside)));
    }
    template <class T, class Inside>
    void list(const Quantity& quantity, const std::vector<T>&, const Inside& inside) {
        add(quantity, {{"type", "array"}, {"items", rules_of_element<T>(inside)}});
    }
    template <class Maybe, class Inside>
    void optional_list(const Quantity& quantity, const Maybe&, const Inside& inside) {
        using Element = typename std::remove_cvref_t<decltype(*std::declval<Maybe>())>::value_type;
        add(quantity, or_null({{"type", "array"}, {"items", rules_of_element<Element>(inside)}}));
    }

    ordered_json rules() const;

private:
    void add(const Quantity& quantity, ordered_json rules);

    template <class T, class Inside>
    static ordered_json rules_of_element(const Inside& inside) {
        const std::remove_cvref_t<T> nothing{};
        SchemaVisitor inner;
        inside(inner, nothing);
        return inner.rules();
    }

    ordered_json properties_ = ordered_json::object();
};

/// The rules for objects that are like one or the other: what both have is required.
ordered_json either(const ordered_json& one, const ordered_json& other);

/// The head of a schema, with title and description.
ordered_json schema_document(const char* title, const char* description);

}  // namespace meniscus::cli
