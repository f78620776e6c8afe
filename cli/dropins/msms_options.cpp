// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/msms_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "dropins/strict_number.h"
#include "meniscus/errors.h"

namespace meniscus::dropins {
namespace {

/// The arguments one after the other.
class Arguments {
public:
    explicit Arguments(const std::vector<std::string>& words) : words_(words) {}

    bool empty() const { return next_ == words_.size(); }

    const std::string& take(const std::string& option) {
        if (empty()) throw UsageError(option + ": its value is missing; see meniscus-msms -h");
        return words_[next_++];
    }

    double number(const std::string& option, bool may_be_zero) {
        const std::string& text = take(option);
        const auto value = strict_number(text);
        if (!value || *value < 0.0 || (*value == 0.0 && !may_be_zero))
            throw UsageError(fmt::format("{}: '{}' is not a {} number", option, text,
                                         may_be_zero ? "finite, non-negative" : "finite, positive"));
        return *value;
    }

    std::uint32_t whole(const std::string& option, std::uint32_t most) {
        const std::string& text = take(option);
        const auto value = strict_number(text);
        if (!value || *value < 0.0 || *value > most || *value != std::floor(*value))
            throw UsageError(fmt::format("{}: '{}' is not a whole number from 0 to {}", option, text, most));
        return static_cast<std::uint32_t>(*value);
    }

private:
    const std::vector<std::string>& words_;
    std::size_t next_ = 0;
};

using Action = void (*)(MsmsRequest&, Arguments&, const std::string& option);

struct Option {
    const char* name;
    const char* help;
    Action act;
};

void no_difference(MsmsRequest& request, Arguments& /*rest*/, const std::string& option) {
    request.warnings.push_back(option + " has no effect here");
}

[[noreturn]] void refuse_server(MsmsRequest& /*request*/, Arguments& /*rest*/, const std::string& option) {
    throw UsageError(option + ": there is no server mode; name files with -if and -of");
}

void set_surface(MsmsRequest& request, Arguments& rest, const std::string& option) {
    const std::string& kind = rest.take(option);
    if (kind != "tses" && kind != "ases")
        throw UsageError(fmt::format("{}: must be tses or ases, not '{}'", option, kind));
    request.triangulated = kind == "tses";
}

void set_cavity(MsmsRequest& request, Arguments& rest, const std::string& option) {
    constexpr std::uint32_t kMostAtoms = 3;
    const std::uint32_t count = rest.whole(option, kMostAtoms);
    if (count == 0) throw UsageError(option + ": needs from 1 to 3 atoms");
    request.cavity_atoms.clear();
    for (std::uint32_t i = 0; i < count; ++i) request.cavity_atoms.push_back(rest.whole(option, 0x7fffffffU));
}

// In MSMS's order, which decides what an abbreviation means.
constexpr std::array kOptions{
    Option{"-probe_radius", "R     probe radius, Å [1.5]",
           [](auto& request, auto& rest, const auto& option) { request.probe = rest.number(option, true); }},
    Option{"-density", "D          vertices per Å² of surface [1.0]",
           [](auto& request, auto& rest, const auto& option) { request.density = rest.number(option, false); }},
    Option{"-hdensity", "D         accepted, but the density is the same everywhere",
           [](auto& request, auto& rest, const auto& option) { request.hdensity = rest.number(option, false); }},
    Option{"-surface", "tses|ases  triangulated, or only its areas [tses]", &set_surface},
    Option{"-no_area", "           do not compute analytical areas",
           [](auto& request, auto&, const auto&) { request.with_area = false; }},
    Option{"-socketName", "        refused: there is no server mode", &refuse_server},
    Option{"-socketPort", "        refused", &refuse_server},
    Option{"-xdr", "               refused", &refuse_server},
    Option{"-sinetd", "            refused", &refuse_server},
    Option{"-noh", "               ignore spheres of radius 1.2",
           [](auto& request, auto&, const auto&) { request.without_hydrogens = true; }},
    Option{"-no_rest_on_pbr", "    no effect", &no_difference},
    Option{"-no_rest", "           no effect", &no_difference},
    Option{"-if", "FILE            spheres: x y z radius [1 name] per line",
           [](auto& request, auto& rest, const auto& option) { request.input = rest.take(option); }},
    Option{"-of", "STEM            write STEM.vert and STEM.face",
           [](auto& request, auto& rest, const auto& option) { request.surface = rest.take(option); }},
    Option{"-af", "STEM            write STEM.area, areas per sphere",
           [](auto& request, auto& rest, const auto& option) { request.area = rest.take(option); }},
    Option{"-no_header", "         no header lines in .vert and .face",
           [](auto& request, auto&, const auto&) { request.with_header = false; }},
    Option{"-free_vertices", "     no effect", &no_difference},
    Option{"-all_components", "    every closed piece; all but the first as STEM_N",
           [](auto& request, auto&, const auto&) { request.all_components = true; }},
    Option{"-one_cavity", "N A...  the piece that N (1 to 3) spheres touch, counted from 0", &set_cavity},
};

const Option& find_option(const std::string& word) {
    const auto* found = std::find_if(kOptions.begin(), kOptions.end(), [&](const Option& option) {
        return word.size() > 1 && std::string_view(option.name).starts_with(word);
    });
    if (found == kOptions.end()) throw UsageError(word + ": unknown option; see meniscus-msms -h");
    return *found;
}

}  // namespace

MsmsRequest parse_msms(const std::vector<std::string>& arguments) {
    MsmsRequest request;
    request.help = arguments == std::vector<std::string>{"-h"} || arguments == std::vector<std::string>{"-help"} ||
                   arguments == std::vector<std::string>{"--help"};
    if (request.help) return request;
    Arguments rest(arguments);
    while (!rest.empty()) {
        const Option& option = find_option(rest.take(""));
        option.act(request, rest, option.name);
    }
    if (request.hdensity != MsmsRequest{}.hdensity && request.hdensity != request.density)
        request.warnings.push_back("-hdensity has no effect here: the density is the same everywhere");
    return request;
}

std::string msms_usage() {
    std::string text = "Usage: meniscus-msms -if FILE [-of STEM] [-af STEM] [options]\n";
    for (const Option& option : kOptions) text += fmt::format("  {} {}\n", option.name, option.help);
    return text + "Options may be abbreviated. docs/howto/replace-msms.md describes the differences from MSMS.\n";
}

}  // namespace meniscus::dropins
