// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/records.h"

#include <fmt/core.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <thread>
#include <utility>

#include "meniscus/errors.h"
#include "messages.h"
#include "platform/files/atomic_file.h"

namespace meniscus::cli::batch {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr int kLockAttempts = 10;
constexpr std::chrono::milliseconds kLockPause{100};

std::string name_of(const Shard& shard) { return fmt::format("shard-{}-of-{}", shard.index, shard.count); }

std::string text_of(const ordered_json& line) {
    return line.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

/// Nothing if the line is no record, or lacks what every record has.
std::optional<Record> record_of(const std::string& line) {
    try {
        const ordered_json all = ordered_json::parse(line);
        for (const char* number : {"size", "archive_end"})
            if (!all.at(number).is_number_integer()) return std::nullopt;
        Record record{all.at("result"), all.at("times"), all["size"], all["archive_end"]};
        if (record.name().empty() || !record.result.at("status").is_string()) return std::nullopt;
        record.outputs();
        radii_of(record.result);
        return record;
    } catch (const ordered_json::exception&) {
        return std::nullopt;
    }
}

/// What of a header must be the same for a run to go on.
ordered_json lasting(ordered_json header) {
    for (const char* key : {"inputs", "mixed_radii"}) header.erase(key);
    return header;
}

[[noreturn]] void cannot_write(const std::string& path) {
    throw OutputError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
}

/// The records of one shard, in order of their names.
class DoneFile {
public:
    explicit DoneFile(const std::string& path) : path_(path), lines_(path) {
        std::string line;
        std::getline(lines_, line);
        header_ = ordered_json::parse(line, nullptr, false);
        if (!header_.is_object() || !header_.contains("inputs") || !header_.contains("command") ||
            !header_.value("mixed_radii", ordered_json(false)).is_boolean())
            throw InputError(path + ": cannot be read; run the shard again with --resume");
        advance();
    }

    const ordered_json& header() const { return header_; }
    const std::optional<Record>& current() const { return current_; }

    void advance() {
        std::string line;
        current_.reset();
        if (!std::getline(lines_, line)) return;
        current_ = record_of(line);
        if (!current_) throw InputError(path_ + ": is damaged; run the shard again with --resume");
    }

private:
    std::string path_;
    std::ifstream lines_;
    ordered_json header_;
    std::optional<Record> current_;
};

/// How many shards the runs that left their logs were.
int count_of_shards(const std::string& state) {
    std::optional<int> count;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(state, error)) {
        const std::string name = entry.path().filename().string();
        int index = 0;
        int of = 0;
        if (!name.ends_with(".log") || std::sscanf(name.c_str(), "shard-%d-of-%d.log", &index, &of) != 2) continue;
        if (count && *count != of)
            throw InputError(fmt::format(
                "{}: has shards out of {} and out of {}; give all shards of a batch the same number of parts", state,
                *count, of));
        count = of;
    }
    if (error || !count) throw InputError(state + ": holds no results of a batch");
    return *count;
}

std::vector<DoneFile> open_shards(const Places& places) {
    const int count = count_of_shards(places.state());
    std::vector<DoneFile> shards;
    for (int i = 0; i < count; ++i) {
        const std::string path = places.done({i, count});
        if (!fs::exists(path))
            throw InputError(
                fmt::format("{}: shard {}/{} is not finished; run it with --resume", places.state(), i, count));
        shards.emplace_back(path);
        const ordered_json& first = shards.front().header();
        const ordered_json& header = shards.back().header();
        if (header["inputs"] != first["inputs"] || header["command"] != first["command"])
            throw InputError(
                fmt::format("{}: shard {}/{} was given different inputs or options from 0/{}; run it again",
                            places.state(), i, count, count));
    }
    return shards;
}

void move_file(const std::string& from, const std::string& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) throw OutputError(fmt::format("{}: cannot be written: {}", to, error.message()));
}

bool may_mix_radii(const DoneFile& shard) { return shard.header().value("mixed_radii", false); }

}  // namespace

Places::Places(const std::string& out, const Shard& shard) : shard_(shard), is_archive_(out.ends_with(".tar")) {
    if (is_archive_) {
        const std::string stem = out.substr(0, out.size() - 4);
        outputs_ = shard.count == 1 ? out : fmt::format("{}-{}-of-{}.tar", stem, shard.index, shard.count);
        state_ = stem + ".batch";
        results_ = stem + ".jsonl";
        times_ = stem + ".times.jsonl";
    } else {
        outputs_ = out;
        state_ = out + "/.batch";
        results_ = out + "/results.jsonl";
        times_ = out + "/times.jsonl";
    }
}

std::string Places::log() const { return state_ + "/" + name_of(shard_) + ".log"; }
std::string Places::done(const Shard& shard) const { return state_ + "/" + name_of(shard) + ".done"; }
std::string Places::work() const { return state_ + "/" + name_of(shard_) + ".work"; }

Log::Log(const Places& places, const ordered_json& header, bool resume) : path_(places.log()) {
    std::error_code error;
    fs::create_directories(places.state(), error);
    if (error) throw OutputError(fmt::format("{}: cannot be created: {}", places.state(), error.message()));
    file_ = Descriptor(path_, O_RDWR | O_CREAT | O_APPEND);
    if (!file_.is_open()) cannot_write(path_);
    lock();
    load(header, resume);
    const std::string line = text_of(header);
    append_line(line);
    size_ += static_cast<std::int64_t>(line.size());
}

/// A run that was killed may hold the lock for a moment longer, in a process that it was about to start.
void Log::lock() const {
    for (int attempt = 0; flock(file_.number(), LOCK_EX | LOCK_NB) != 0; ++attempt) {
        if (errno != EWOULDBLOCK) {
            print_warning(std::cerr,
                          fmt::format("{}: cannot be locked ({}); make sure that no other run is working on this shard",
                                      path_, std::strerror(errno)));
            return;
        }
        if (attempt == kLockAttempts) throw UsageError(fmt::format("{}: another run is working on this shard", path_));
        std::this_thread::sleep_for(kLockPause);
    }
}

void Log::load(const ordered_json& header, bool resume) {
    std::ifstream lines(path_);
    std::string line;
    bool begun = false;
    while (std::getline(lines, line) && !lines.eof()) {
        const auto length = static_cast<std::int64_t>(line.size()) + 1;
        if (const auto record = record_of(line)) {
            if (!begun) throw InputError(path_ + ": is damaged; choose another --out");
            note(*record, length);
            continue;
        }
        const ordered_json older = ordered_json::parse(line, nullptr, false);
        if (!older.is_object() || older.contains("result"))
            throw InputError(path_ + ": is damaged; choose another --out");
        if (!resume)
            throw UsageError(fmt::format(
                "{}: exists from an earlier run; add --resume to continue it, or choose another --out", path_));
        if (lasting(older) != lasting(header))
            throw UsageError(fmt::format(
                "{}: was started by another version or with different options ({:.400}); choose another --out", path_,
                lasting(older).dump(-1, ' ', true)));
        begun = true;
        size_ += length;
    }
    if (ftruncate(file_.number(), size_) != 0) cannot_write(path_);
}

/// Takes in what the line behind all others says.
void Log::note(const Record& record, std::int64_t length) {
    entries_.insert_or_assign(record.name(), Entry{.offset = size_,
                                                   .length = length,
                                                   .succeeded = record.succeeded(),
                                                   .size = record.size,
                                                   .archive_end = record.archive_end,
                                                   .radii = radii_of(record.result),
                                                   .outputs = record.outputs()});
    size_ += length;
}

void Log::append_line(const std::string& line) {
    for (std::size_t written = 0; written < line.size();) {
        const ssize_t count = write(file_.number(), line.data() + written, line.size() - written);
        if (count < 0 && errno != EINTR) cannot_write(path_);
        written += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
}

void Log::append(const Record& record) {
    const std::string line = text_of({{"result", record.result},
                                      {"times", record.times},
                                      {"size", record.size},
                                      {"archive_end", record.archive_end}});
    append_line(line);
    note(record, static_cast<std::int64_t>(line.size()));
}

std::string Log::line_of(const Entry& entry) const {
    std::string line(static_cast<std::size_t>(entry.length), '\0');
    if (pread(file_.number(), line.data(), line.size(), entry.offset) != entry.length)
        throw InputError(path_ + ": cannot be read; it has changed in the meantime");
    return line;
}

Record Log::read(const Entry& entry) const {
    if (auto record = record_of(line_of(entry))) return std::move(*record);
    throw InputError(path_ + ": is damaged; choose another --out");
}

void Log::finish(const std::string& path, const ordered_json& header, const std::vector<Task>& tasks) const {
    std::vector<std::string> names;
    names.reserve(tasks.size());
    for (const Task& task : tasks) names.push_back(task.input.name);
    std::sort(names.begin(), names.end());
    AtomicFile file(path);
    file.write(text_of(header));
    for (const std::string& name : names) file.write(line_of(entries_.at(name)));
    file.commit();
}

Collected collect(const Places& places) {
    std::vector<DoneFile> shards = open_shards(places);
    const bool may_mix = std::all_of(shards.begin(), shards.end(), may_mix_radii);
    // What a kill leaves of them stays out of the outputs.
    const std::string new_results = places.state() + "/results.jsonl";
    const std::string new_times = places.state() + "/times.jsonl";
    AtomicFile results(new_results);
    AtomicFile times(new_times);
    Collected collected;
    std::map<std::string, std::string> radii;  // set -> an input
    const auto comes_first = [](const DoneFile& a, const DoneFile& b) {
        return a.current() && (!b.current() || a.current()->name() < b.current()->name());
    };
    for (;;) {
        DoneFile& shard = *std::min_element(shards.begin(), shards.end(), comes_first);
        if (!shard.current()) break;
        const Record& record = *shard.current();
        radii.emplace(radii_of(record.result), record.name());
        radii.erase("");
        if (radii.size() > 1 && !may_mix) refuse_mixed_radii(radii);
        results.write(text_of(record.result));
        times.write(text_of(record.times));
        ++collected.inputs;
        if (!record.succeeded()) collected.failed.push_back(without_report(record.result));
        shard.advance();
    }
    results.commit();
    times.commit();
    move_file(new_results, places.results());
    move_file(new_times, places.times());
    return collected;
}

ordered_json without_report(ordered_json result) {
    result.erase("report");
    return result;
}

std::string radii_of(const ordered_json& result) {
    const ordered_json report = result.value("report", ordered_json());
    const ordered_json& one = report.is_array() && !report.empty() ? report.front() : report;
    return one.is_object() && one.contains("input") ? one["input"].value("radii", "") : "";
}

void refuse_mixed_radii(const std::map<std::string, std::string>& radii) {
    const auto& [first, one] = *radii.begin();
    const auto& [second, other] = *std::next(radii.begin());
    throw UsageError(
        fmt::format("{} has radii {} and {} has radii {}: their results are not comparable; choose one set with "
                    "--radii, or allow this with --mixed-radii",
                    one, first, other, second));
}

}  // namespace meniscus::cli::batch
