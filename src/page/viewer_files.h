// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The files of viewer/ and three.js, as the build has put them into the program (cmake/embed.cmake).
#pragma once

#include <string_view>

namespace meniscus::page {

extern const std::string_view kViewerHtml;
extern const std::string_view kViewerStyle;
extern const std::string_view kViewerScript;  ///< the modules, one behind the other
extern const std::string_view kThreeLicence;
extern const std::string_view kThreeScript;  ///< empty if built without it

}  // namespace meniscus::page
