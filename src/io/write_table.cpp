// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "io/csv.h"
#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "platform/files/atomic_file.h"
#include "reading/lower_case.h"

namespace meniscus {
namespace {

// Writes one cell; nothing and non-finite numbers leave the field of a CSV file empty.
struct CsvCell {
    AtomicFile& file;

    void operator()(std::monostate) const {}
    void operator()(bool value) const { file.write(value ? "true" : "false"); }
    void operator()(std::int64_t value) const { file.write(std::to_string(value)); }
    void operator()(double value) const {
        if (std::isfinite(value)) file.number(value);
    }
    void operator()(const std::string& text) const { write_csv_field(file, text); }
};

std::string json_text(std::string_view text) {
    constexpr std::string_view kHex = "0123456789abcdef";
    std::string quoted(1, '"');
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            quoted.append(1, '\\').append(1, c);
        else if (byte < 0x20)
            quoted.append("\\u00").append(1, kHex[byte >> 4U]).append(1, kHex[byte & 15U]);
        else
            quoted.append(1, byte < 0x80 ? c : '?');  // names are ASCII; anything else might not be UTF-8
    }
    quoted += '"';
    return quoted;
}

struct JsonCell {
    AtomicFile& file;

    void operator()(std::monostate) const { file.write("null"); }
    void operator()(bool value) const { file.write(value ? "true" : "false"); }
    void operator()(std::int64_t value) const { file.write(std::to_string(value)); }
    void operator()(double value) const {
        if (std::isfinite(value))
            file.number(value);
        else
            file.write("null");
    }
    void operator()(const std::string& text) const { file.write(json_text(text)); }
};

void write_csv(AtomicFile& file, const Table& table) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (i > 0) file.write(',');
        write_csv_field(file, table.columns[i]);
    }
    file.write('\n');
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i > 0) file.write(',');
            std::visit(CsvCell{file}, row[i]);
        }
        file.write('\n');
    }
}

void write_json(AtomicFile& file, const Table& table) {
    file.write("[");
    const char* before = "\n";
    for (const auto& row : table.rows) {
        file.write(before);
        file.write('{');
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i > 0) file.write(", ");
            file.write(json_text(table.columns[i]));
            file.write(": ");
            std::visit(JsonCell{file}, row[i]);
        }
        file.write('}');
        before = ",\n";
    }
    file.write("\n]\n");
}

}  // namespace

void write_table(const std::string& path, const Table& table) {
    const bool json = lower_case(path).ends_with(".json");
    if (!json && !lower_case(path).ends_with(".csv"))
        throw UsageError(path + ": unknown suffix for a table; choose .csv or .json");
    if (std::any_of(table.rows.begin(), table.rows.end(),
                    [&](const auto& row) { return row.size() != table.columns.size(); }))
        throw UsageError(path + ": every row of a table needs one cell per column");
    AtomicFile file(path);
    if (json)
        write_json(file, table);
    else
        write_csv(file, table);
    file.commit();
}

}  // namespace meniscus
