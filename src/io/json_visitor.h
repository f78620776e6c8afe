// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Results as JSON: a visitor of what meniscus/describe_results.h describes.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "meniscus/describe_results.h"
#include "meniscus/vec3.h"

namespace meniscus {

using nlohmann::ordered_json;

template <class T>
ordered_json json_of(const T& value) {
    return value;
}
inline ordered_json json_of(const Vec3& p) { return ordered_json::array({p.x, p.y, p.z}); }
template <class T>
ordered_json json_of(const std::optional<T>& value) {
    return value ? json_of(*value) : ordered_json();
}
template <class... T>
ordered_json json_of(const std::variant<T...>& value) {
    return std::visit([](const auto& held) { return json_of(held); }, value);
}

/// Writes the keys of a result into an object.
class JsonVisitor {
public:
    explicit JsonVisitor(ordered_json& object) : object_(object) { object_ = ordered_json::object(); }

    template <class T>
    void operator()(const Quantity& quantity, const T& value) {
        object_[quantity.name] = json_of(value);
    }
    template <class T, std::size_t N>
    void operator()(const Quantity& quantity, T value, const Words<T, N>& words) {
        object_[quantity.name] = word_for(words, value);
    }
    template <class Inside>
    void block(const Quantity& quantity, const Inside& inside) {
        JsonVisitor inner(object_[quantity.name]);
        inside(inner);
    }
    template <class Maybe, class Inside>
    void optional_block(const Quantity& quantity, const Maybe& maybe, const Inside& inside) {
        if (!maybe) return (*this)(quantity, nullptr);
        block(quantity, [&](auto& inner) { inside(inner, *maybe); });
    }
    template <class T, class Inside>
    void list(const Quantity& quantity, const std::vector<T>& elements, const Inside& inside) {
        ordered_json& all = object_[quantity.name] = ordered_json::array();
        for (const T& element : elements) {
            JsonVisitor inner(all.emplace_back());
            inside(inner, element);
        }
    }
    template <class Maybe, class Inside>
    void optional_list(const Quantity& quantity, const Maybe& maybe, const Inside& inside) {
        if (!maybe) return (*this)(quantity, nullptr);
        list(quantity, *maybe, inside);
    }

private:
    ordered_json& object_;
};

/// What a visit of JsonVisitor makes.
template <class Describe>
ordered_json described_as_json(const Describe& describe) {
    ordered_json object;
    JsonVisitor visit(object);
    describe(visit);
    return object;
}

}  // namespace meniscus
