// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What a batch knows of its inputs: a line per input in a log while it runs, one file of all when its shards are done.
//
// A log is only ever appended to, by whole lines, so that whoever goes on after a kill finds all that was done.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "batch/descriptor.h"
#include "batch/plan.h"

namespace meniscus::cli::batch {

/// Where a batch keeps its files.
class Places {
public:
    /// out   a folder, or an archive: a name that ends in .tar
    Places(const std::string& out, const Shard& shard);

    bool is_archive() const { return is_archive_; }
    const std::string& outputs() const { return outputs_; }  ///< the folder, or the archive of this shard
    const std::string& state() const { return state_; }      ///< folder of logs and of what is under way
    std::string log() const;
    std::string done(const Shard& shard) const;  ///< of a shard that has done all
    std::string work() const;                    ///< folder of what this shard has under way
    const std::string& results() const { return results_; }
    const std::string& times() const { return times_; }

private:
    Shard shard_;
    bool is_archive_;
    std::string outputs_;
    std::string state_;
    std::string results_;
    std::string times_;
};

/// What came of one input.
struct Record {
    nlohmann::ordered_json result;  ///< the same whenever and wherever it is computed
    nlohmann::ordered_json times;   ///< what is not
    std::uint64_t size = 0;         ///< of the input, bytes
    std::int64_t archive_end = 0;   ///< bytes of the archive of outputs, with those of this input

    std::string name() const { return result.at("input"); }
    bool succeeded() const { return result.at("status") == "done"; }
    std::vector<std::string> outputs() const { return result.at("outputs"); }
};

/// Where the last record of an input is, and what a run must know of it; reports stay on disk.
struct Entry {
    std::int64_t offset = 0;  ///< of its line in the log, bytes
    std::int64_t length = 0;
    bool succeeded = false;
    std::uint64_t size = 0;
    std::int64_t archive_end = 0;
    std::string radii;  ///< see radii_of()
    std::vector<std::string> outputs;
};

/// The log of one shard, held by one process at a time.
class Log {
public:
    /// Opens the log and reads what it has; a line that was not finished is taken away.
    ///
    /// header    what a run is: its command, its shard. A log that exists must have been begun by the same.
    /// resume    whether a log may exist
    /// throws    UsageError if there is one and it may not, or if it is of another run, or another process holds it;
    ///           InputError, OutputError
    Log(const Places& places, const nlohmann::ordered_json& header, bool resume);

    /// By names of inputs.
    const std::map<std::string, Entry>& entries() const { return entries_; }
    void append(const Record& record);

    /// throws   InputError
    Record read(const Entry& entry) const;

    /// Writes the records of these tasks, by name, for collect().
    void finish(const std::string& path, const nlohmann::ordered_json& header, const std::vector<Task>& tasks) const;

private:
    void lock() const;
    void load(const nlohmann::ordered_json& header, bool resume);
    void append_line(const std::string& line);
    void note(const Record& record, std::int64_t length);
    std::string line_of(const Entry& entry) const;

    std::string path_;
    Descriptor file_;
    std::int64_t size_ = 0;
    std::map<std::string, Entry> entries_;
};

struct Collected {
    std::size_t inputs = 0;
    std::vector<nlohmann::ordered_json> failed;  ///< results without success, without reports, by name
};

/// Puts the results of all shards into one file, a line of JSON per input by the names of the inputs, and their times
/// into another.
///
/// throws   InputError where a shard is missing, is not done, or has been given other inputs; UsageError where radii
///          are mixed and were not to be
Collected collect(const Places& places);

/// A result as a table of failures shows it.
nlohmann::ordered_json without_report(nlohmann::ordered_json result);

/// The set of radii that a result was computed with; empty where nothing was.
std::string radii_of(const nlohmann::ordered_json& result);

/// radii   a set and an input that has it, at least two
/// throws  UsageError
[[noreturn]] void refuse_mixed_radii(const std::map<std::string, std::string>& radii);

}  // namespace meniscus::cli::batch
