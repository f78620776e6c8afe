// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/bcif_encodings.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "core/bits.h"
#include "reading/text.h"

namespace meniscus::reading {
namespace {

constexpr std::size_t kLongestChain = 16;  // of encodings; writers use four at most

// The numbers that stand for types of arrays.
enum class BcifType : std::uint8_t {
    Int8 = 1,
    Int16 = 2,
    Int32 = 3,
    Uint8 = 4,
    Uint16 = 5,
    Uint32 = 6,
    Float32 = 32,
    Float64 = 33
};

const PackedValue& member(const PackedValue& map, std::string_view key) {
    const PackedValue* const value = map.find(key);
    if (value == nullptr) throw DamagedData("\"" + std::string(key) + "\" is missing", map.at);
    return *value;
}

std::string_view text_of(const PackedValue& map, std::string_view key) {
    const PackedValue& value = member(map, key);
    if (!value.is_text()) throw DamagedData("\"" + std::string(key) + "\" is neither text nor bytes", value.at);
    return value.text;
}

double real_of(const PackedValue& map, std::string_view key) {
    const PackedValue& value = member(map, key);
    if (!value.is_number() || !std::isfinite(value.real))
        throw DamagedData("\"" + std::string(key) + "\" is not a finite number", value.at);
    return value.real;
}

// Writers in languages with one kind of numbers may write 3 as 3.0.
std::int64_t integer_of(const PackedValue& map, std::string_view key) {
    constexpr double kLargest = 1e15;
    const double real = real_of(map, key);
    if (std::abs(real) > kLargest || real != std::floor(real))
        throw DamagedData("\"" + std::string(key) + "\" is not an integer", member(map, key).at);
    return static_cast<std::int64_t>(real);
}

BcifType type_of(const PackedValue& map, std::string_view key) {
    const std::int64_t type = integer_of(map, key);
    if ((type < 1 || type > 6) && type != 32 && type != 33)
        throw DamagedData("\"" + std::string(key) + "\" is not a type of numbers", member(map, key).at);
    return static_cast<BcifType>(type);
}

// ---- ByteArray

template <class Number>
Number little_endian(const char* at) {
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), at, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    return bit_cast<Number>(bytes);
}

template <class Number, class Value>
std::vector<Value> numbers_of(std::string_view bytes, const PackedValue& encoding) {
    if (bytes.size() % sizeof(Number) != 0)
        throw DamagedData("an array of " + std::to_string(bytes.size()) + " bytes does not hold whole numbers of " +
                              std::to_string(sizeof(Number)),
                          encoding.at);
    std::vector<Value> values(bytes.size() / sizeof(Number));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = Value{little_endian<Number>(bytes.data() + i * sizeof(Number))};
    return values;
}

BcifArray byte_array(std::string_view bytes, const PackedValue& encoding) {
    switch (type_of(encoding, "type")) {
        case BcifType::Int8:
            return numbers_of<std::int8_t, std::int64_t>(bytes, encoding);
        case BcifType::Int16:
            return numbers_of<std::int16_t, std::int64_t>(bytes, encoding);
        case BcifType::Int32:
            return numbers_of<std::int32_t, std::int64_t>(bytes, encoding);
        case BcifType::Uint8:
            return numbers_of<std::uint8_t, std::int64_t>(bytes, encoding);
        case BcifType::Uint16:
            return numbers_of<std::uint16_t, std::int64_t>(bytes, encoding);
        case BcifType::Uint32:
            return numbers_of<std::uint32_t, std::int64_t>(bytes, encoding);
        case BcifType::Float32:
            return BcifReals{numbers_of<float, double>(bytes, encoding), true};
        default:
            return BcifReals{numbers_of<double, double>(bytes, encoding), false};
    }
}

// ---- integers that stand for real numbers

// Divided, not multiplied by the inverse: 12345 / 1000 is the number that "12.345" is.
BcifReals fixed_point(const BcifIntegers& integers, const PackedValue& encoding) {
    const double factor = real_of(encoding, "factor");
    if (factor == 0.0) throw DamagedData("\"factor\" is 0", encoding.at);
    BcifReals reals;
    reals.values.reserve(integers.size());
    for (const std::int64_t integer : integers) reals.values.push_back(static_cast<double>(integer) / factor);
    return reals;
}

BcifReals interval_quantization(const BcifIntegers& integers, const PackedValue& encoding) {
    const double low = real_of(encoding, "min");
    const double high = real_of(encoding, "max");
    const std::int64_t steps = integer_of(encoding, "numSteps");
    if (steps < 2) throw DamagedData("\"numSteps\" is below 2", encoding.at);
    BcifReals reals;
    reals.values.reserve(integers.size());
    for (const std::int64_t integer : integers) {
        if (integer < 0 || integer >= steps) throw DamagedData("a step that is none of \"numSteps\"", encoding.at);
        const double share = static_cast<double>(integer) / static_cast<double>(steps - 1);
        reals.values.push_back(low + (high - low) * share);
    }
    return reals;
}

// ---- integers that stand for integers

BcifIntegers run_length(const BcifIntegers& runs, const PackedValue& encoding, std::size_t at_most) {
    const std::int64_t size = integer_of(encoding, "srcSize");
    if (size < 0 || static_cast<std::uint64_t>(size) > at_most)
        throw DamagedData("runs of " + std::to_string(size) + " values in all, more than a file of this size holds",
                          encoding.at);
    if (runs.size() % 2 != 0) throw DamagedData("a run without its length", encoding.at);
    BcifIntegers values;
    values.reserve(static_cast<std::size_t>(size));
    for (std::size_t i = 0; i < runs.size(); i += 2) {
        const std::int64_t room = size - static_cast<std::int64_t>(values.size());
        if (runs[i + 1] < 0 || runs[i + 1] > room) throw DamagedData("runs longer than their sum", encoding.at);
        values.insert(values.end(), static_cast<std::size_t>(runs[i + 1]), runs[i]);
    }
    if (values.size() != static_cast<std::size_t>(size)) throw DamagedData("runs shorter than their sum", encoding.at);
    return values;
}

// Sums leave 32 bits at one end and come in at the other: writers compute in arrays of 32-bit integers.
BcifIntegers delta(BcifIntegers values, const PackedValue& encoding) {
    const bool is_unsigned = encoding.find("srcType") != nullptr && type_of(encoding, "srcType") == BcifType::Uint32;
    auto sum = static_cast<std::uint32_t>(integer_of(encoding, "origin"));
    for (std::int64_t& value : values) {
        sum += static_cast<std::uint32_t>(value);
        value = is_unsigned ? std::int64_t{sum} : std::int64_t{static_cast<std::int32_t>(sum)};
    }
    return values;
}

// A value is a sum: of the largest or smallest that a byte or two hold, as often as needed, and a last one that is
// less.
BcifIntegers integer_packing(const BcifIntegers& parts, const PackedValue& encoding) {
    const std::int64_t bytes = integer_of(encoding, "byteCount");
    if (bytes != 1 && bytes != 2) throw DamagedData("\"byteCount\" is neither 1 nor 2", encoding.at);
    const PackedValue& is_unsigned = member(encoding, "isUnsigned");
    const std::int64_t range = bytes == 1 ? 0x100 : 0x10000;
    const std::int64_t low = is_unsigned.integer != 0 ? 0 : -range / 2;
    const std::int64_t high = low + range - 1;
    BcifIntegers values;
    values.reserve(parts.size());
    std::int64_t sum = 0;
    bool is_open = false;
    for (const std::int64_t part : parts) {
        sum += part;
        is_open = part == high || (part == low && low < 0);
        if (!is_open) values.push_back(std::exchange(sum, 0));
    }
    if (is_open) throw DamagedData("the last integer is cut off", encoding.at);
    if (static_cast<std::int64_t>(values.size()) != integer_of(encoding, "srcSize"))
        throw DamagedData("\"srcSize\" is not the number of integers, " + std::to_string(values.size()), encoding.at);
    return values;
}

// ---- texts

BcifIntegers integers_of(BcifArray array, std::size_t at) {
    if (auto* const integers = std::get_if<BcifIntegers>(&array)) return std::move(*integers);
    throw DamagedData("other values where integers belong", at);
}

// Where each character begins, and the end: writers count characters as UTF-16 has them, of which one of four bytes
// takes two. Empty for ASCII, where a character is a byte.
std::vector<std::size_t> starts_of_characters(std::string_view text) {
    const auto is_ascii = [](char c) { return static_cast<std::uint8_t>(c) < 0x80; };
    std::vector<std::size_t> starts;
    if (std::all_of(text.begin(), text.end(), is_ascii)) return starts;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<std::uint8_t>(text[i]);
        if (byte < 0x80 || byte >= 0xc0) starts.push_back(i);
        if (byte >= 0xf0) starts.push_back(i);
    }
    starts.push_back(text.size());
    return starts;
}

// The different texts of an array, one behind the other in one text.
BcifTexts different_texts(const PackedValue& encoding, const BcifIntegers& offsets) {
    const std::string_view all = text_of(encoding, "stringData");
    const std::vector<std::size_t> starts = starts_of_characters(all);
    const std::size_t end = starts.empty() ? all.size() : starts.size() - 1;
    const auto place = [&](std::int64_t offset) {
        return starts.empty() ? static_cast<std::size_t>(offset) : starts[static_cast<std::size_t>(offset)];
    };
    BcifTexts texts;
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
        const std::int64_t from = offsets[i];
        const std::int64_t to = offsets[i + 1];
        if (from < 0 || to < from || static_cast<std::uint64_t>(to) > end)
            throw DamagedData("a text outside of \"stringData\"", encoding.at);
        texts.push_back(all.substr(place(from), place(to) - place(from)));
    }
    return texts;
}

BcifArray decode_chain(std::string_view bytes, const PackedValue& encodings, std::size_t at_most);

BcifTexts string_array(std::string_view bytes, const PackedValue& encoding, std::size_t at_most) {
    const PackedValue& of_offsets = member(encoding, "offsetEncoding");
    const BcifIntegers offsets =
        integers_of(decode_chain(text_of(encoding, "offsets"), of_offsets, at_most), of_offsets.at);
    const BcifTexts texts = different_texts(encoding, offsets);
    const PackedValue& of_data = member(encoding, "dataEncoding");
    BcifTexts values;
    for (const std::int64_t index : integers_of(decode_chain(bytes, of_data, at_most), of_data.at)) {
        if (index < -1 || index >= static_cast<std::int64_t>(texts.size()))
            throw DamagedData("text " + std::to_string(index) + " of " + std::to_string(texts.size()), encoding.at);
        values.push_back(index < 0 ? std::string_view() : texts[static_cast<std::size_t>(index)]);
    }
    return values;
}

// ---- chains of encodings

BcifArray decode_first(std::string_view bytes, const PackedValue& encoding, std::size_t at_most) {
    const std::string_view kind = text_of(encoding, "kind");
    if (kind == "ByteArray") return byte_array(bytes, encoding);
    if (kind == "StringArray") return string_array(bytes, encoding, at_most);
    throw DamagedData("encoding " + shown(kind) + " without ByteArray below it", encoding.at);
}

BcifArray decode_next(BcifIntegers integers, const PackedValue& encoding, std::size_t at_most) {
    const std::string_view kind = text_of(encoding, "kind");
    if (kind == "FixedPoint") return fixed_point(integers, encoding);
    if (kind == "IntervalQuantization") return interval_quantization(integers, encoding);
    if (kind == "RunLength") return run_length(integers, encoding, at_most);
    if (kind == "Delta") return delta(std::move(integers), encoding);
    if (kind == "IntegerPacking") return integer_packing(integers, encoding);
    throw DamagedData("encoding " + shown(kind) + " is unknown or out of place", encoding.at);
}

// The last encoding is undone first.
BcifArray decode_chain(std::string_view bytes, const PackedValue& encodings, std::size_t at_most) {
    const std::vector<PackedValue>& chain = encodings.items;
    if (encodings.kind != PackedValue::Kind::Array || chain.empty() || chain.size() > kLongestChain)
        throw DamagedData("no list of encodings", encodings.at);
    BcifArray array = decode_first(bytes, chain.back(), at_most);
    for (std::size_t i = chain.size() - 1; i-- > 0;)
        array = decode_next(integers_of(std::move(array), chain[i].at), chain[i], at_most);
    return array;
}

}  // namespace

BcifArray decode_bcif(const PackedValue& data, std::size_t at_most) {
    return decode_chain(text_of(data, "data"), member(data, "encoding"), at_most);
}

std::size_t size_of(const BcifArray& array) {
    if (const auto* const reals = std::get_if<BcifReals>(&array)) return reals->values.size();
    if (const auto* const integers = std::get_if<BcifIntegers>(&array)) return integers->size();
    return std::get<BcifTexts>(array).size();
}

}  // namespace meniscus::reading
