// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/bcif_tables.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "meniscus/errors.h"
#include "platform/files/digits.h"
#include "reading/lower_case.h"
#include "structure/bcif_encodings.h"
#include "structure/message_pack.h"

namespace meniscus::reading {
namespace {

// An atom of 21 columns takes three bytes at least for its coordinates: runs may make all else small. Real files have
// less than one value per byte.
constexpr std::size_t kValuesPerByte = 8;

// Decodes columns, and counts what they hold against the size of the file.
class ColumnReader {
public:
    ColumnReader(std::size_t file_size, std::deque<std::string>& texts)
        : at_most_(file_size), room_(kValuesPerByte * file_size), texts_(texts) {}

    std::vector<std::string_view> values(const PackedValue& column, std::size_t rows) {
        const PackedValue* const data = column.find("data");
        if (data == nullptr) throw DamagedData("a column without data", column.at);
        if (rows > room_) throw DamagedData("more values than a file of this size holds", column.at);
        room_ -= rows;
        std::vector<std::string_view> values = written(sized(*data, rows));
        const PackedValue* const mask = column.find("mask");
        if (mask != nullptr && mask->kind != PackedValue::Kind::Nil) apply(sized(*mask, rows), mask->at, values);
        return values;
    }

private:
    BcifArray sized(const PackedValue& data, std::size_t rows) const {
        BcifArray array = decode_bcif(data, at_most_);
        if (size_of(array) == rows) return array;
        throw DamagedData(std::to_string(size_of(array)) + " values in a table of " + std::to_string(rows) + " rows",
                          data.at);
    }

    static void apply(const BcifArray& mask, std::size_t at, std::vector<std::string_view>& values) {
        constexpr std::array<std::string_view, 3> kMissing{"", ".", "?"};  // 0: there is a value
        const auto* const marks = std::get_if<BcifIntegers>(&mask);
        if (marks == nullptr) throw DamagedData("a mask that is not of integers", at);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::int64_t mark = (*marks)[i];
            if (mark < 0 || mark > 2) throw DamagedData("a mask that is none of 0, 1 and 2", at);
            if (mark > 0) values[i] = kMissing.at(static_cast<std::size_t>(mark));
        }
    }

    std::vector<std::string_view> written(BcifArray array) {
        if (auto* const texts = std::get_if<BcifTexts>(&array)) return quoted(std::move(*texts));
        if (const auto* const integers = std::get_if<BcifIntegers>(&array))
            return printed(integers->size(), [&](Digits& digits, std::size_t i) {
                return digits_of(std::int64_t{(*integers)[i]}, digits);
            });
        const auto& reals = std::get<BcifReals>(array);
        // The fewest digits that a float is known by are those that it was made from: 12.345, not 12.34500026702881.
        return printed(reals.values.size(), [&](Digits& digits, std::size_t i) {
            const double value = reals.values[i];
            return reals.single ? digits_of(static_cast<float>(value), digits) : digits_of(value, digits);
        });
    }

    // print(digits, i) is the text of value i, held in `digits`.
    template <class Print>
    std::vector<std::string_view> printed(std::size_t count, const Print& print) {
        std::string& text = texts_.emplace_back();
        std::vector<std::size_t> ends;
        ends.reserve(count);
        Digits digits;
        for (std::size_t i = 0; i < count; ++i) {
            text += print(digits, i);
            ends.push_back(text.size());
        }
        std::vector<std::string_view> values(count);
        for (std::size_t i = 0, begin = 0; i < count; begin = ends[i++])
            values[i] = std::string_view(text).substr(begin, ends[i] - begin);
        return values;
    }

    // Whoever takes these for CIF takes a quote at the beginning for one that is not part of the value, and CIF has no
    // empty values. Texts that repeat, as names do, are the same bytes.
    BcifTexts quoted(BcifTexts values) {
        std::string_view before;
        std::string_view quoted_before;
        for (std::string_view& value : values) {
            if (value.empty()) value = "?";
            if (value[0] != '\'' && value[0] != '"' && value[0] != ';') continue;
            if (value.data() != before.data() || value.size() != before.size()) {
                before = value;
                quoted_before = texts_.emplace_back('"' + std::string(value) + '"');
            }
            value = quoted_before;
        }
        return values;
    }

    std::size_t at_most_;  // values of a column
    std::size_t room_;     // values of all columns to come
    std::deque<std::string>& texts_;
};

std::string name_of(const PackedValue& map, std::string_view key) {
    const PackedValue* const name = map.find(key);
    if (name == nullptr || !name->is_text())
        throw DamagedData("no name where \"" + std::string(key) + "\" is to be", map.at);
    return std::string(name->text);
}

const std::vector<PackedValue>& list_of(const PackedValue& map, std::string_view key) {
    const PackedValue* const list = map.find(key);
    if (list == nullptr || list->kind != PackedValue::Kind::Array)
        throw DamagedData("no list where \"" + std::string(key) + "\" is to be", map.at);
    return list->items;
}

std::size_t rows_of(const PackedValue& category) {
    const PackedValue* const rows = category.find("rowCount");
    const bool is_count = rows != nullptr && rows->is_number() && rows->real >= 0.0 && rows->real <= 1e15;
    if (!is_count || rows->real != std::floor(rows->real))
        throw DamagedData("no number of rows where \"rowCount\" is to be", category.at);
    return static_cast<std::size_t>(rows->real);
}

// Tags of a block must differ, in any case of letters; a category's name begins with an underscore.
class TableReader {
public:
    TableReader(ColumnReader& columns, const BcifChoice& chosen) : columns_(columns), chosen_(chosen) {}

    BcifBlock block(const PackedValue& packed) {
        BcifBlock block;
        block.name = name_of(packed, "header");
        tags_.clear();
        for (const PackedValue& category : list_of(packed, "categories")) {
            BcifCategory table = this->category(category);
            if (!table.columns.empty()) block.categories.push_back(std::move(table));
        }
        std::sort(tags_.begin(), tags_.end());
        const auto twin = std::adjacent_find(tags_.begin(), tags_.end());
        if (twin != tags_.end()) throw DamagedData("a second table or column of the same name", packed.at);
        return block;
    }

private:
    BcifCategory category(const PackedValue& packed) {
        const std::string name = name_of(packed, "name");
        const std::string prefix = (name.starts_with('_') ? name : "_" + name) + ".";
        BcifCategory table;
        table.rows = rows_of(packed);
        if (table.rows == 0) return table;
        for (const PackedValue& column : list_of(packed, "columns")) {
            std::string tag = prefix + name_of(column, "name");
            if (!chosen_(tag)) continue;
            tags_.push_back(lower_case(tag));
            table.columns.push_back({std::move(tag), columns_.values(column, table.rows)});
        }
        if (!table.columns.empty()) tags_.push_back(lower_case(prefix));
        return table;
    }

    ColumnReader& columns_;
    const BcifChoice& chosen_;
    std::vector<std::string> tags_;  // of the block, and names of its tables
};

BcifTables tables_of(std::string_view bytes, const BcifChoice& chosen) {
    const PackedValue file = unpack(bytes);
    BcifTables tables;
    ColumnReader columns(bytes.size(), tables.texts);
    TableReader reader(columns, chosen);
    for (const PackedValue& block : list_of(file, "dataBlocks")) tables.blocks.push_back(reader.block(block));
    return tables;
}

}  // namespace

bool is_bcif(std::string_view bytes) {
    if (bytes.empty()) return false;
    const auto first = static_cast<std::uint8_t>(bytes[0]);
    if ((first < 0x80 || first > 0x8f) && first != 0xde && first != 0xdf) return false;
    constexpr std::size_t kOfKey = 20;
    const std::string_view start = bytes.substr(0, kOfKey);
    const auto has = [&](std::string_view key) { return start.find(key) != std::string_view::npos; };
    return has("encoder") || has("version") || has("dataBlocks");
}

BcifTables read_bcif(std::string_view bytes, const std::string& file, const BcifChoice& chosen) {
    try {
        return tables_of(bytes, chosen);
    } catch (const DamagedData& damage) {
        throw InputError(file + ": damaged BinaryCIF: " + damage.what() + " at byte " + std::to_string(damage.at()) +
                         "; fetch the file again");
    }
}

}  // namespace meniscus::reading
