// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/html.h"

#include <nettle/sha2.h>

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "meniscus/version.h"
#include "page/packed_text.h"
#include "page/viewer_files.h"

namespace meniscus::page {
namespace {

/// 'sha256-...' as policies write it.
std::string fingerprint(std::string_view script) {
    sha256_ctx context;
    sha256_init(&context);
    sha256_update(&context, script.size(), reinterpret_cast<const std::uint8_t*>(script.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context, digest.size(), digest.data());
    return "'sha256-" + base64({reinterpret_cast<const char*>(digest.data()), digest.size()}) + "'";
}

std::string policy() {
    return "default-src 'none'; script-src " + fingerprint(kViewerScript) + " " + fingerprint(kThreeScript) +
           "; style-src " + fingerprint(kViewerStyle) + "; img-src data: blob:; base-uri 'none'; form-action 'none'";
}

/// Every {{name}} replaced once; what is put in is not looked at again.
std::string filled(std::string_view text, const std::map<std::string_view, std::string>& values) {
    std::string result;
    while (true) {
        const std::size_t open = text.find("{{");
        if (open == std::string_view::npos) return result.append(text);
        const std::size_t close = text.find("}}", open);
        if (close == std::string_view::npos) throw std::logic_error("viewer/page.html: {{ without }}");
        result.append(text.substr(0, open)).append(values.at(text.substr(open + 2, close - open - 2)));
        text.remove_prefix(close + 2);
    }
}

/// Through the library that writes the data, too, so that both replace the same bytes.
std::string valid_utf8(std::string_view text) {
    const std::string quoted = nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    return nlohmann::json::parse(quoted).get<std::string>();
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : valid_utf8(text)) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string tables_of(std::span<const PageRow> rows) {
    std::string html;
    const std::string* section = nullptr;
    for (const PageRow& row : rows) {
        if (section == nullptr || *section != row.section) {
            html += section == nullptr ? "" : "</tbody></table>\n";
            html += "<h3>" + escaped(row.section) + "</h3>\n<table><tbody>\n";
        }
        section = &row.section;
        html += "<tr><th scope=\"row\">" + escaped(row.label) + "</th><td>" + escaped(row.value) + "</td></tr>\n";
    }
    return section == nullptr ? html : html + "</tbody></table>\n";
}

/// What is seen where scripts or WebGL are missing; without a picture nothing but a notice.
std::string still_picture(const PageParts& parts) {
    if (parts.picture.empty()) return {};
    return "<img id=\"picture\" alt=\"The surface of " + escaped(parts.description) +
           "\" src=\"data:image/png;base64," + base64(parts.picture) + "\">";
}

std::string make_html(const PageParts& parts) {
    return filled(kViewerHtml, {{"policy", policy()},
                                {"title", escaped(parts.title)},
                                {"description", escaped(parts.description)},
                                {"version", kVersion},
                                {"style", std::string(kViewerStyle)},
                                {"picture", still_picture(parts)},
                                {"tables", parts.tables},
                                {"licence", escaped(kThreeLicence)},
                                {"three", base64(deflated(kThreeScript))},
                                {"data", base64(deflated(parts.data))},
                                {"script", std::string(kViewerScript)}});
}

}  // namespace meniscus::page
