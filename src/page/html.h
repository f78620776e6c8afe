// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The HTML of a page: text that stays text, and the template of viewer/page.html filled in.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "meniscus/page.h"

namespace meniscus::page {

/// Text as HTML shows it between tags and in quoted attributes; bytes that are no UTF-8 become U+FFFD.
std::string escaped(std::string_view text);

/// The numbers of a page as tables, section by section.
std::string tables_of(std::span<const PageRow> rows);

struct PageParts {
    std::string title;        ///< plain text
    std::string picture;      ///< PNG; empty: none
    std::string data;         ///< of page_data(), not yet compressed
    std::string tables;       ///< HTML
    std::string description;  ///< plain text
};

/// The whole file. Its policy (Content-Security-Policy) lets nothing run but the viewer's own scripts, by their
/// SHA-256, and lets nothing be loaded.
std::string make_html(const PageParts& parts);

}  // namespace meniscus::page
