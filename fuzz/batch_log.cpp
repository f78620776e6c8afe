// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What a batch has left of itself: the log that a run goes on from, and the records of shards that are done.
#include "batch/records.h"
#include "fuzzed_file.h"

namespace {

using namespace meniscus;
namespace batch = cli::batch;

void go_on(const batch::Places& places) {
    const nlohmann::ordered_json header{{"command", "surface"}, {"inputs", "1"}};
    const batch::Log log(places, header, true);
    for (const auto& [name, entry] : log.entries())
        fuzz::require(log.read(entry).name() == name, "an entry leads to its record");
}

void gather(const batch::Places& places) {
    const batch::Collected collected = batch::collect(places);
    fuzz::require(collected.failed.size() <= collected.inputs, "what failed are inputs");
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::FuzzedFile log("out/.batch/shard-0-of-1.log");
    static const fuzz::FuzzedFile done("out/.batch/shard-0-of-1.done");
    static const fuzz::FuzzedFile results("out/results.jsonl");
    static const fuzz::FuzzedFile times("out/times.jsonl");
    static const fuzz::FuzzedFile new_results("out/.batch/results.jsonl");
    static const fuzz::FuzzedFile new_times("out/.batch/times.jsonl");
    static const std::string folder = results.path().substr(0, results.path().rfind('/'));
    static const batch::Places places(folder, {});
    log.write(fuzz::text_of(data, size));
    done.write(fuzz::text_of(data, size));
    fuzz::read_or_refuse(folder, [] { fuzz::use_or_refuse([] { go_on(places); }); });
    fuzz::read_or_refuse(folder, [] { fuzz::use_or_refuse([] { gather(places); }); });
    return 0;
}
