// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Options from text, by the descriptions that the other clients use.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "meniscus/describe_options.h"
#include "meniscus/describe_pockets.h"
#include "meniscus/file_words.h"
#include "objects.h"
#include "reading/option_numbers.h"

namespace meniscus::c {
namespace {

bool flag_from(const std::string& name, const std::string& text) {
    if (text == "true" || text == "1") return true;
    if (text == "false" || text == "0") return false;
    throw UsageError(name + ": must be true or false, not '" + text + "'");
}

int whole_from(const Option& option, const std::string& text) {
    const double value = parse_number(option.name, text, option.range);
    if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
        throw UsageError(std::string(option.name) + ": must be a whole number, not " + text);
    return static_cast<int>(value);
}

/// Sets the option of one name, among those that a description visits.
struct OptionSetter {
    const std::string& name;
    const std::string& text;
    bool found = false;
    std::vector<Option> changed{};

    void operator()(const Option& option, bool& target) {
        if (is(option)) set(option, target, flag_from(name, text));
    }
    void operator()(const Option& option, double& target) {
        if (is(option)) set(option, target, parse_number(name, text, option.range));
    }
    void operator()(const Option& option, int& target) {
        if (is(option)) set(option, target, whole_from(option, text));
    }
    void operator()(const Option& option, std::size_t& target) {
        if (is(option)) set(option, target, parse_memory(name, text));
    }
    void operator()(const Option& option, double& target, double (*of)(double)) {
        if (is(option)) set(option, target, of(parse_number(name, text, option.range)));
    }
    void operator()(const Option& option, FlowOptions& flow, const Words<FlowName, 3>& words) {
        FlowName chosen = flow.name;
        (*this)(option, chosen, words);
        if (name == option.name) flow = flow_of(chosen);
    }
    template <class T, std::size_t N>
    void operator()(const Option& option, T& target, const Words<T, N>& words) {
        if (is(option)) set(option, target, parse_word(name, text, words));
    }

private:
    bool is(const Option& option) {
        if (name != option.name) return false;
        found = true;
        return true;
    }
    template <class T>
    void set(const Option& option, T& target, T value) {
        if (target != value) changed.push_back(option);
        target = value;
    }
};

std::vector<std::string> names_in(std::string_view list) {
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        names.emplace_back(list.substr(begin, end - begin));
        begin = end + 1;
    }
    if (std::find(names.begin(), names.end(), "") != names.end())
        throw UsageError("chains: empty name in '" + std::string(list) + "'; write A,B");
    return names;
}

/// Sets an option of reading; false if it is none.
bool set_reading(ReadOptions& read, const std::string& name, const std::string& text) {
    if (name == "radii")
        read.radii = text;
    else if (name == "hydrogens")
        read.hydrogens = parse_word(name, text, kHydrogenWords);
    else if (name == "hetero")
        read.hetero = parse_word(name, text, kHeteroWords);
    else if (name == "waters")
        read.keep_waters = flag_from(name, text);
    else if (name == "model" && text == "join")
        read.join_models = true;
    else if (name == "model")
        read.model = parse_count(name, text);
    else if (name == "assembly")
        read.assembly = text;
    else if (name == "altloc")
        read.altloc = text;
    else if (name == "chains")
        read.chains = names_in(text);
    else if (name == "select")
        read.select = text;
    else if (name == "strict_radii")
        read.strict_radii = flag_from(name, text);
    else
        return false;
    return true;
}

void set(Options& options, const std::string& name, const std::string& text) {
    OptionSetter setter{name, text};
    describe(options.surface, setter);
    options.given.insert(options.given.end(), setter.changed.begin(), setter.changed.end());
    describe(options.run, setter);
    describe(options.pockets, setter);
    if (setter.found || set_reading(options.read, name, text)) return;
    if (name == "exact")
        options.surface.exact = flag_from(name, text);
    else if (name == "between")
        options.between = text;
    else
        throw UsageError("there is no option '" + name + "'; docs/reference/options.md lists them");
}

}  // namespace

std::string spell(std::string_view option, std::string_view value) {
    return spell_as_member(option == "keep_waters" ? "waters" : option, value);
}

}  // namespace meniscus::c

meniscus_options* meniscus_options_new(void) { return new (std::nothrow) meniscus_options; }

void meniscus_options_free(meniscus_options* options) { delete options; }

meniscus_status meniscus_options_set(meniscus_options* options, const char* name, const char* value) {
    using namespace meniscus::c;
    return guarded([&] {
        need(options, "options");
        need(name, "name");
        need(value, "value");
        set(*options, name, value);
    });
}
