// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Comma-separated text, as RFC 4180 says, and what spreadsheets make of it where the comma is for decimals.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reading/text.h"

namespace meniscus::reading {

struct CsvCell {
    std::string text;  ///< without the quotes
    Place place{};
};

using CsvRow = std::vector<CsvCell>;

/// The rows of a text whose lines end with '\n'; blank lines between them are skipped. Cells are separated by commas,
/// or, where the first line has none, by semicolons or else by tabs.
///
/// file     name for messages
/// throws   InputError for quotes that do not end or have something behind them
std::vector<CsvRow> read_csv(std::string_view text, const std::string& file);

}  // namespace meniscus::reading
