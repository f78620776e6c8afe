// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What a surface was computed from and with, in the words of the report.
#pragma once

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "meniscus/describe_options.h"
#include "meniscus/structure.h"

namespace meniscus {

/// Options by their names, as a description visits them; null for those that have no effect beside the others.
struct OptionsAsJson {
    const SurfaceOptions& others;
    nlohmann::ordered_json block = nlohmann::ordered_json::object();

    template <class T>
    void operator()(const Option& option, const T& value) {
        add(option, value);
    }
    void operator()(const Option& option, double value) {
        if (std::isinf(value))
            add(option, "inf");
        else
            add(option, value);
    }
    void operator()(const Option& option, std::size_t megabytes) {
        block[std::string(option.name) + "_mb"] = megabytes > 0 ? nlohmann::ordered_json(megabytes) : nullptr;
    }
    void operator()(const Option& /*option*/, double /*value*/, double (* /*of*/)(double)) {}
    void operator()(const Option& option, const FlowOptions& flow, const Words<FlowName, 3>& words) {
        add(option, word_for(words, flow.name));
    }
    template <class T, std::size_t N>
    void operator()(const Option& option, T value, const Words<T, N>& words) {
        add(option, word_for(words, value));
    }

private:
    template <class T>
    void add(const Option& option, const T& value) {
        block[option.name] = has_effect(option, others) ? nlohmann::ordered_json(value) : nullptr;
    }
};

/// All options that decide a surface.
inline nlohmann::ordered_json options_block(const SurfaceOptions& options) {
    OptionsAsJson json{options};
    describe_shape(options, json);
    describe(options.flow, json);
    describe(options.remesh, json);
    return json.block;
}

/// {"meniscus": version, "input": {file, sha256, radii, probe}, "options": options_block()}.
std::string options_json(const SurfaceOptions& options, const Structure& structure);

}  // namespace meniscus
