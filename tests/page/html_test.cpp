// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/html.h"

#include <gtest/gtest.h>

namespace meniscus::page {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

TEST(Html, EscapedTextHasNoMarkup) {
    EXPECT_EQ(escaped("<b a=\"1\" c='2'>&"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;");
}

TEST(Html, BytesThatAreNoTextAreReplaced) { EXPECT_EQ(escaped("a\xFFz"), "a\xEF\xBF\xBDz"); }

TEST(Html, RowsOfASectionShareATable) {
    const std::vector<PageRow> rows{{"A", "x", "1"}, {"A", "y", "2"}, {"B", "z", "<3"}};
    const std::string html = tables_of(rows);
    EXPECT_EQ(count(html, "<table>"), 2U);
    EXPECT_EQ(count(html, "</table>"), 2U);
    EXPECT_EQ(count(html, "<h3>A</h3>"), 1U);
    EXPECT_NE(html.find("<td>&lt;3</td>"), std::string::npos);
    EXPECT_EQ(tables_of({}), "");
}

TEST(Html, EveryPlaceOfTheTemplateIsFilled) {
    const std::string html = make_html(
        {.title = "t <script>", .picture = "png", .data = "d", .tables = "<p>here</p>", .description = "{{data}}"});
    EXPECT_NE(html.find("<title>t &lt;script&gt;</title>"), std::string::npos);
    EXPECT_NE(html.find("<p>here</p>"), std::string::npos);
    EXPECT_NE(html.find("<h1>{{data}}</h1>"), std::string::npos) << "what is put in is not filled again";
    EXPECT_NE(html.find("three.js authors"), std::string::npos) << "the licence travels along";
}

TEST(Html, NothingIsLoadedFromAnywhere) {
    const std::string html = make_html({.title = "", .picture = "", .data = "", .tables = "", .description = ""});
    EXPECT_NE(html.find("default-src &#39;none&#39;") + html.find("default-src 'none'"), 2 * std::string::npos);
    EXPECT_EQ(count(html, " src=\"http"), 0U);
    EXPECT_EQ(count(html, "@import"), 0U);
    EXPECT_EQ(count(html, "unsafe-inline"), 0U);
}

}  // namespace
}  // namespace meniscus::page
