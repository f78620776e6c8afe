// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "bcif_writer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

#include "reading/numbers.h"

namespace meniscus::testing {
namespace {

template <class Number>
std::string little_bytes(Number number) {
    std::string bytes(sizeof(Number), '\0');
    std::memcpy(bytes.data(), &number, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

template <class Number>
std::string big_bytes(Number number) {
    std::string bytes = little_bytes(number);
    std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

template <class Number, class Value>
std::string array_bytes(const std::vector<Value>& values) {
    std::string bytes;
    for (const Value value : values) bytes += little_bytes(static_cast<Number>(value));
    return bytes;
}

std::string encoding(const std::string& kind, std::vector<PackedMember> members) {
    members.insert(members.begin(), {"kind", packed(kind)});
    return packed_map(members);
}

std::string byte_array(int type) { return encoding("ByteArray", {{"type", packed(std::int64_t{type})}}); }

std::string size_member(const Integers& values) { return packed(static_cast<std::int64_t>(values.size())); }

Integers runs_of(const Integers& values) {
    Integers runs;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i == 0 || values[i] != values[i - 1]) runs.insert(runs.end(), {values[i], 0});
        ++runs.back();
    }
    return runs;
}

Integers differences(const Integers& values, std::int64_t origin) {
    Integers result;
    for (const std::int64_t value : values) {
        result.push_back(value - origin);
        origin = value;
    }
    return result;
}

Integers parts_of(const Integers& values, std::int64_t low, std::int64_t high) {
    Integers parts;
    for (std::int64_t value : values) {
        for (; value >= high; value -= high) parts.push_back(high);
        for (; low < 0 && value <= low; value -= low) parts.push_back(low);
        parts.push_back(value);
    }
    return parts;
}

Encoded packed_integers(const Integers& values, int bytes) {
    const bool is_unsigned = std::all_of(values.begin(), values.end(), [](std::int64_t v) { return v >= 0; });
    const std::int64_t range = bytes == 1 ? 0x100 : 0x10000;
    const std::int64_t low = is_unsigned ? 0 : -range / 2;
    const Integers parts = parts_of(values, low, low + range - 1);
    const std::string packing = encoding("IntegerPacking", {{"byteCount", packed(std::int64_t{bytes})},
                                                            {"isUnsigned", packed(is_unsigned)},
                                                            {"srcSize", size_member(values)}});
    return {bytes == 1 ? array_bytes<std::uint8_t>(parts) : array_bytes<std::uint16_t>(parts),
            {packing, byte_array((is_unsigned ? 3 : 0) + bytes)}};
}

void put_before(Encoded& encoded, const std::string& first) {
    encoded.encodings.insert(encoded.encodings.begin(), first);
}

// ---- mmCIF texts

struct Word {
    std::string text;
    bool is_value = false;  // in quotes, or a text field
};

std::vector<Word> words_of(std::string_view text) {
    std::vector<Word> words;
    for (std::size_t i = 0; i < text.size();) {
        const bool at_line = i == 0 || text[i - 1] == '\n';
        if (text[i] == ' ' || text[i] == '\n' || text[i] == '\t') {
            ++i;
        } else if (text[i] == '#') {
            i = std::min(text.find('\n', i), text.size());
        } else if (text[i] == ';' && at_line) {
            const std::size_t end = text.find("\n;", i);
            words.push_back({std::string(text.substr(i + 1, end - i - 1)), true});
            i = end + 2;
        } else if (text[i] == '\'' || text[i] == '"') {
            std::size_t end = i + 1;
            while (text[end] != text[i] || (end + 1 < text.size() && text[end + 1] != ' ' && text[end + 1] != '\n'))
                ++end;
            words.push_back({std::string(text.substr(i + 1, end - i - 1)), true});
            i = end + 1;
        } else {
            const std::size_t end = std::min(text.find_first_of(" \n\t", i), text.size());
            words.push_back({std::string(text.substr(i, end - i)), false});
            i = end;
        }
    }
    return words;
}

bool is_tag(const Word& word) { return !word.is_value && word.text[0] == '_'; }
bool is_loop(const Word& word) { return !word.is_value && word.text == "loop_"; }

using Values = std::vector<std::string>;

// In the order of the file, "_atom_site.id" and the values of it.
std::vector<std::pair<std::string, Values>> columns_of(std::string_view cif) {
    const std::vector<Word> words = words_of(cif);
    std::vector<std::pair<std::string, Values>> columns;
    for (std::size_t i = 1; i < words.size();) {
        const bool loop = is_loop(words[i]);
        i += loop ? 1 : 0;
        const std::size_t first = columns.size();
        while (i < words.size() && is_tag(words[i])) {
            columns.push_back({words[i++].text, {}});
            if (!loop) break;
        }
        const std::size_t width = columns.size() - first;
        for (std::size_t n = 0; i < words.size() && !is_tag(words[i]) && !is_loop(words[i]); ++n)
            columns[first + n % width].second.push_back(words[i++].text);
    }
    return columns;
}

std::size_t decimals_of(const std::string& text) {
    const std::size_t point = text.find('.');
    return point == std::string::npos ? 0 : text.size() - point - 1;
}

bool is_missing(const std::string& text) { return text == "." || text == "?"; }

// The values as numbers, if those that are not missing are that and small enough for 32 bits with all their decimals.
std::optional<std::vector<double>> numbers_of(const Values& values, bool whole) {
    std::vector<double> numbers;
    for (const std::string& text : values) {
        const auto number = is_missing(text) ? std::optional(0.0) : reading::finite_number(text);
        const bool fits = number && std::abs(*number) < (whole ? 1e6 : 1e4) && decimals_of(text) <= (whole ? 0 : 5);
        if (!fits || (whole && !is_missing(text) && text != std::to_string(static_cast<std::int64_t>(*number))))
            return {};
        numbers.push_back(*number);
    }
    return numbers;
}

// Large numbers are sums of very many bytes.
IntegerCoding affordable(IntegerCoding coding, double largest) {
    const bool in_bytes = coding == IntegerCoding::Packed8 || coding == IntegerCoding::All;
    return in_bytes && largest > 1e4 ? IntegerCoding::Packed16 : coding;
}

double largest_of(const std::vector<double>& numbers) {
    double largest = 0.0;
    for (const double number : numbers) largest = std::max(largest, std::abs(number));
    return largest;
}

Encoded encoded_decimals(const Values& values, const std::vector<double>& numbers, std::size_t turn) {
    std::size_t decimals = 0;
    for (const std::string& text : values) decimals = std::max(decimals, decimals_of(text));
    const double largest = largest_of(numbers);
    if (turn % 7 == 0) return doubles(numbers);
    if (turn % 7 == 1 && decimals <= 3 && largest < 1e3) return floats(numbers);  // six digits
    const double factor = std::pow(10.0, static_cast<double>(decimals));
    return fixed_point(numbers, factor, affordable(static_cast<IntegerCoding>(turn % 6), largest * factor));
}

Encoded encoded_column(const Values& values, std::size_t turn) {
    const auto coding = static_cast<IntegerCoding>(turn % 6);
    if (const auto numbers = numbers_of(values, true))
        return encoded(Integers(numbers->begin(), numbers->end()), affordable(coding, largest_of(*numbers)));
    if (const auto numbers = numbers_of(values, false)) return encoded_decimals(values, *numbers, turn);
    return texts(values, coding);
}

std::string mask_of(const Values& values, std::size_t turn) {
    Integers mask;
    for (const std::string& text : values) mask.push_back(text == "." ? 1 : text == "?" ? 2 : 0);
    const bool has_all = std::all_of(mask.begin(), mask.end(), [](std::int64_t mark) { return mark == 0; });
    return has_all ? packed_nil()
                   : packed_data(encoded(mask, turn % 2 == 0 ? IntegerCoding::Packed8 : IntegerCoding::Runs));
}

}  // namespace

std::string packed(std::int64_t number) {
    if (number >= 0 && number < 128) return std::string(1, static_cast<char>(number));
    if (number < 0 && number >= -32) return std::string(1, static_cast<char>(number));
    if (number >= INT16_MIN && number <= INT16_MAX) return "\xd1" + big_bytes(static_cast<std::int16_t>(number));
    if (number >= INT32_MIN && number <= INT32_MAX) return "\xd2" + big_bytes(static_cast<std::int32_t>(number));
    return "\xd3" + big_bytes(number);
}

std::string packed(double number) { return "\xcb" + big_bytes(number); }

std::string packed(bool value) { return value ? "\xc3" : "\xc2"; }

std::string packed(const std::string& text) {
    const std::size_t size = text.size();
    if (size < 32) return static_cast<char>(0xa0 + size) + text;
    if (size < 256) return "\xd9" + std::string(1, static_cast<char>(size)) + text;
    return "\xdb" + big_bytes(static_cast<std::uint32_t>(size)) + text;
}

std::string packed_bytes(const std::string& bytes) {
    return bytes.size() < 256 ? "\xc4" + std::string(1, static_cast<char>(bytes.size())) + bytes
                              : "\xc6" + big_bytes(static_cast<std::uint32_t>(bytes.size())) + bytes;
}

std::string packed_array(const std::vector<std::string>& items) {
    std::string all = items.size() < 16 ? std::string(1, static_cast<char>(0x90 + items.size()))
                                        : "\xdc" + big_bytes(static_cast<std::uint16_t>(items.size()));
    for (const std::string& item : items) all += item;
    return all;
}

std::string packed_map(const std::vector<PackedMember>& members) {
    std::string all(1, static_cast<char>(0x80 + members.size()));
    for (const PackedMember& member : members) all += packed(member.key) + member.value;
    return all;
}

Encoded encoded(const Integers& values, IntegerCoding coding) {
    const std::int64_t origin = values.empty() ? 0 : values[0];
    switch (coding) {
        case IntegerCoding::Plain:
            return {array_bytes<std::int32_t>(values), {byte_array(3)}};
        case IntegerCoding::Packed8:
            return packed_integers(values, 1);
        case IntegerCoding::Packed16:
            return packed_integers(values, 2);
        case IntegerCoding::Runs: {
            Encoded inner = encoded(runs_of(values), IntegerCoding::Plain);
            put_before(inner, encoding("RunLength", {{"srcType", "\x03"}, {"srcSize", size_member(values)}}));
            return inner;
        }
        case IntegerCoding::Deltas: {
            Encoded inner = encoded(differences(values, origin), IntegerCoding::Packed16);
            put_before(inner, encoding("Delta", {{"srcType", "\x03"}, {"origin", packed(origin)}}));
            return inner;
        }
        default: {
            const Integers steps = differences(values, origin);
            Encoded inner = encoded(runs_of(steps), IntegerCoding::Packed8);
            put_before(inner, encoding("RunLength", {{"srcType", "\x03"}, {"srcSize", size_member(steps)}}));
            put_before(inner, encoding("Delta", {{"srcType", "\x03"}, {"origin", packed(origin)}}));
            return inner;
        }
    }
}

Encoded fixed_point(const std::vector<double>& values, double factor, IntegerCoding coding) {
    Integers integers;
    for (const double value : values) integers.push_back(std::llround(value * factor));
    Encoded inner = encoded(integers, coding);
    put_before(inner, encoding("FixedPoint", {{"factor", packed(factor)}, {"srcType", packed(std::int64_t{33})}}));
    return inner;
}

Encoded interval(const std::vector<double>& values, double low, double high, int steps) {
    Integers integers;
    for (const double value : values) integers.push_back(std::llround((value - low) / (high - low) * (steps - 1)));
    Encoded inner = encoded(integers, IntegerCoding::Packed16);
    put_before(inner, encoding("IntervalQuantization", {{"min", packed(low)},
                                                        {"max", packed(high)},
                                                        {"numSteps", packed(std::int64_t{steps})},
                                                        {"srcType", packed(std::int64_t{32})}}));
    return inner;
}

Encoded floats(const std::vector<double>& values) { return {array_bytes<float>(values), {byte_array(32)}}; }

Encoded doubles(const std::vector<double>& values) { return {array_bytes<double>(values), {byte_array(33)}}; }

Encoded texts(const std::vector<std::string>& values, IntegerCoding coding) {
    std::map<std::string, std::int64_t> numbers;
    std::string all;
    Integers offsets{0};
    Integers indices;
    for (const std::string& value : values) {
        const auto [at, is_new] = numbers.try_emplace(value, static_cast<std::int64_t>(numbers.size()));
        indices.push_back(at->second);
        if (!is_new) continue;
        all += value;
        offsets.push_back(static_cast<std::int64_t>(all.size()));
    }
    const Encoded of_offsets = encoded(offsets, IntegerCoding::Deltas);
    const Encoded of_indices = encoded(indices, coding);
    return {of_indices.bytes,
            {encoding("StringArray", {{"dataEncoding", packed_array(of_indices.encodings)},
                                      {"stringData", packed(all)},
                                      {"offsetEncoding", packed_array(of_offsets.encodings)},
                                      {"offsets", packed_bytes(of_offsets.bytes)}})}};
}

std::string packed_data(const Encoded& encoded) {
    return packed_map({{"data", packed_bytes(encoded.bytes)}, {"encoding", packed_array(encoded.encodings)}});
}

std::string bcif_file(const std::vector<Table>& tables) {
    std::vector<std::string> categories;
    for (const Table& table : tables) {
        std::vector<std::string> columns;
        for (const Column& column : table.columns)
            columns.push_back(
                packed_map({{"name", packed(column.name)}, {"data", column.data}, {"mask", column.mask}}));
        categories.push_back(packed_map(
            {{"name", packed(table.name)}, {"rowCount", packed(table.rows)}, {"columns", packed_array(columns)}}));
    }
    const std::string block = packed_map({{"header", packed("X")}, {"categories", packed_array(categories)}});
    return packed_map(
        {{"encoder", packed("test")}, {"version", packed("0.3.0")}, {"dataBlocks", packed_array({block})}});
}

std::string bcif_of(std::string_view cif) {
    std::vector<Table> tables;
    std::size_t turn = 0;
    for (const auto& [tag, values] : columns_of(cif)) {
        const std::string name = tag.substr(0, tag.find('.'));
        if (tables.empty() || tables.back().name != name)
            tables.push_back({name, static_cast<std::int64_t>(values.size()), {}});
        tables.back().columns.push_back(
            {tag.substr(name.size() + 1), packed_data(encoded_column(values, turn)), mask_of(values, turn)});
        ++turn;
    }
    return bcif_file(tables);
}

}  // namespace meniscus::testing
