// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Files of parameters for the program in the place of NanoShaper.
#include <sstream>

#include "dropins/nanoshaper_options.h"
#include "fuzzed_file.h"

namespace {

using namespace meniscus;

void read(std::string_view bytes) {
    std::istringstream stream{std::string(bytes)};
    const dropins::NanoShaperRequest request = dropins::read_nanoshaper(stream, "a.prm");
    fuzz::require(request.grid_scale > 0.0 && request.probe >= 0.0 && request.fill_below >= 0.0 && request.threads >= 0,
                  "numbers are in their ranges");
    for (const std::string& warning : request.warnings) fuzz::require_clear(warning);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::read_or_refuse("a.prm", [&] { read(fuzz::text_of(data, size)); });
    return 0;
}
