// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "described_options.h"

#include <cstddef>

#include "meniscus/describe_options.h"
#include "meniscus/describe_pockets.h"
#include "meniscus/describe_tunnels.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

constexpr Words<NumberRange, 5> kRangeWords{{{"any", NumberRange::Any},
                                             {"positive", NumberRange::Positive},
                                             {"not-negative", NumberRange::NotNegative},
                                             {"negative", NumberRange::Negative},
                                             {"positive-or-infinite", NumberRange::PositiveOrInfinite}}};
constexpr Words<Effect, 4> kEffectWords{{{"always", Effect::Always},
                                         {"with-flow", Effect::WithFlow},
                                         {"with-gaussian-map", Effect::WithGaussianMap},
                                         {"with-edge", Effect::WithEdge}}};

/// A list of what a description visits.
class OptionLister {
public:
    void operator()(const Option& option, const bool& value) { add(option, "flag", value); }
    void operator()(const Option& option, const double& value) {
        const bool is_shown = contains(option.range, value);
        add(option, "number", is_shown ? ordered_json(value) : ordered_json());
    }
    void operator()(const Option& option, const int& value) { add(option, "count", value); }
    void operator()(const Option& option, const std::size_t& /*value*/) { add(option, "memory", nullptr); }
    void operator()(const Option& option, const double& /*value*/, double (* /*of*/)(double)) {
        add(option, "number", nullptr);
    }
    void operator()(const Option& option, const FlowOptions& flow, const Words<FlowName, 3>& words) {
        (*this)(option, flow.name, words);
    }
    template <class T, std::size_t N>
    void operator()(const Option& option, const T& value, const Words<T, N>& words) {
        ordered_json all = ordered_json::array();
        for (const auto& word : words) all.push_back(word.first);
        add(option, "choice", word_for(words, value)).emplace("words", std::move(all));
    }

    const ordered_json& list() const { return list_; }

private:
    ordered_json& add(const Option& option, const char* kind, const ordered_json& value) {
        const std::string standard = option.standard;
        list_.push_back({{"name", option.name},
                         {"kind", kind},
                         {"symbol", option.symbol},
                         {"range", word_for(kRangeWords, option.range)},
                         {"effect", word_for(kEffectWords, option.effect)},
                         {"default", standard.empty() ? value : ordered_json()},
                         {"standard", standard},
                         {"brief", option.brief},
                         {"meaning", option.meaning},
                         {"example", option.example}});
        return list_.back();
    }

    ordered_json list_ = ordered_json::array();
};

template <class Describe>
ordered_json listed(const Describe& describe_them) {
    OptionLister lister;
    describe_them(lister);
    return lister.list();
}

}  // namespace

ordered_json described_options() {
    const SurfaceOptions options;
    return {{"Surface", listed([&](auto& lister) { describe_shape(options, lister); })},
            {"Flow", listed([&](auto& lister) { describe(options.flow, lister); })},
            {"Triangles", listed([&](auto& lister) { describe(options.remesh, lister); })},
            {"Findings", listed([&](auto& lister) { describe_findings(options, lister); })},
            {"Running", listed([&](auto& lister) {
                 const RunOptions run;
                 describe(run, lister);
                 describe_checks(options, lister);
             })},
            {"Pockets", listed([](auto& lister) {
                 const PocketOptions pockets;
                 describe(pockets, lister);
                 const TunnelOptions tunnels;
                 describe(tunnels, lister);
             })}};
}

}  // namespace meniscus::cli
