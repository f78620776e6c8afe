// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Tar archives of structures as inputs of a batch.
#include <algorithm>
#include <filesystem>
#include <set>

#include "batch/archive.h"
#include "batch/inputs.h"
#include "fuzzed_file.h"

namespace {

using namespace meniscus;
namespace batch = cli::batch;

void find(const batch::Sources& sources) {
    std::set<std::string> names;
    for (const batch::Input& input : batch::find_inputs(sources).inputs) {
        fuzz::require(names.insert(input.name).second, "each name once");
        const std::filesystem::path name = input.name;
        fuzz::require(name.is_relative() && std::find(name.begin(), name.end(), "..") == name.end(),
                      "names lead nowhere else");
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::FuzzedFile archive("a.tar");
    static const fuzz::FuzzedFile member("member");
    const std::string_view bytes = fuzz::text_of(data, size);
    archive.write(bytes);
    fuzz::read_or_refuse(archive.path(), [] {
        fuzz::use_or_refuse([] { find({.words = {archive.path()}, .list = {}, .base = {}, .skip = {}}); });
    });
    fuzz::read_or_refuse(archive.path(), [] {
        for (const batch::ArchiveMember& found : batch::list_members(archive.path()))
            batch::extract_member(archive.path(), found.header, member.path());
    });
    return 0;
}
