// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/run.h"

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string_view>
#include <utility>

#include "batch/archive.h"
#include "batch/inputs.h"
#include "interrupt.h"
#include "meniscus/errors.h"
#include "meniscus/version.h"
#include "messages.h"
#include "report.h"

namespace meniscus::cli::batch {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr double kTick = 1.0;   // s between looks where nothing happens
constexpr int kInputError = 3;  // exit codes of the program
constexpr int kChecksFailed = 6;
constexpr std::string_view kErrorMark = "meniscus: error: ";
constexpr std::string_view kWarningMark = "meniscus: warning: ";

/// Folders of a task within its own.
std::string outputs_in(const std::string& folder) { return folder + "/out"; }
std::string report_in(const std::string& folder) { return folder + "/report.json"; }

/// The file that the process of a task reads.
std::string input_of(const Task& task, const std::string& folder) {
    if (!task.input.member) return task.input.path;
    return folder + "/in/" + fs::path(task.input.name).filename().string();
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

/// The last line of messages that begins with `kind`, without that; the very last line if there is none.
std::string last_message(const std::string& messages, std::string_view kind) {
    std::string found;
    std::string last;
    for (std::size_t begin = 0; begin < messages.size();) {
        const std::size_t end = std::min(messages.find('\n', begin), messages.size());
        last = messages.substr(begin, end - begin);
        if (last.starts_with(kind)) found = last.substr(kind.size());
        begin = end + 1;
    }
    return found.empty() ? last : found;
}

std::string status_of(const ProcessEnd& end) {
    if (end.timed_out) return "timed out";
    if (end.signal != 0) return "crashed";
    if (end.exit_code == kChecksFailed) return "checks failed";
    return end.exit_code == 0 ? "done" : "failed";
}

std::string error_of(const ProcessEnd& end, double time_limit) {
    if (end.timed_out) return fmt::format("took longer than {:g} s", time_limit);
    if (end.signal == SIGKILL) return "ended by SIGKILL, probably because memory ran out";
    if (end.signal != 0) return fmt::format("ended by SIG{}", sigabbrev_np(end.signal));
    const std::string message = last_message(end.messages, end.exit_code == kChecksFailed ? kWarningMark : kErrorMark);
    return message.empty() ? fmt::format("exit code {}", end.exit_code) : message;
}

/// Takes what differs from run to run out of a report.
ordered_json split_off_times(ordered_json& report) {
    ordered_json times;
    if (report.is_array()) {
        for (ordered_json& one : report) times.push_back(split_off_times(one));
        return times;
    }
    for (const char* key : {"time_s", "expected", "peak_memory_mb"}) {
        if (report.contains(key)) times[key] = report[key];
        report.erase(key);
    }
    times["threads"] = report["options"]["threads"];
    report["options"].erase("threads");
    return times;
}

ordered_json read_report(const std::string& path) {
    std::ifstream file(path);
    ordered_json report = ordered_json::parse(file, nullptr, false);
    return report.is_discarded() ? ordered_json() : report;
}

bool has_outputs(const ProcessEnd& end) {
    return !end.timed_out && end.signal == 0 && (end.exit_code == 0 || end.exit_code == kChecksFailed);
}

/// What came of a task, without its outputs.
Record record_of(const Task& task, const ProcessEnd& end, const std::string& folder, double time_limit) {
    ordered_json report = has_outputs(end) ? read_report(report_in(folder)) : ordered_json();
    ordered_json times{{"input", task.input.name}, {"wall_s", end.wall_seconds}, {"cpu_s", end.cpu_seconds}};
    if (!report.is_null()) times["run"] = split_off_times(report);
    ordered_json result{{"input", task.input.name}, {"status", status_of(end)}};
    result["exit"] = end.signal == 0 ? ordered_json(end.exit_code) : ordered_json();
    std::string error = status_of(end) == "done" ? "" : error_of(end, time_limit);
    replace_all(error, input_of(task, folder), task.input.name);
    replace_all(error, outputs_in(folder) + "/", "");
    result["error"] = error;
    result["outputs"] = ordered_json::array();
    result["report"] = std::move(report);
    return {std::move(result), std::move(times), task.input.size, 0};
}

void make_folder(const std::string& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) throw OutputError(fmt::format("{}: cannot be created: {}", path, error.message()));
}

void remove_all_of(const std::string& path) {
    std::error_code ignored;  // what is left is removed by the next run
    fs::remove_all(path, ignored);
}

/// What the same run has again when it goes on.
ordered_json header_of(const Request& request, const Shard& shard, const std::vector<Input>& inputs) {
    std::vector<std::string> command{request.command};
    command.insert(command.end(), request.options.begin(), request.options.end());
    for (const std::string& ending : request.endings) command.push_back("-o=" + ending);
    if (!request.history.empty()) command.push_back("--history=" + request.history);
    return {{"meniscus", kVersion},
            {"command", command},
            {"shard", {shard.index, shard.count}},
            {"inputs", fingerprint(inputs)},
            {"mixed_radii", request.may_mix_radii}};
}

std::vector<Task> checked_plan(const Request& request, const Shard& shard, const Places& places,
                               const std::vector<Input>& inputs, const ReadFiles& read_files) {
    std::vector<Task> tasks = plan(inputs, shard);
    check_outputs(request, places, tasks, read_files);
    return tasks;
}

}  // namespace

Run::Run(const Request& request, const Shard& shard, const Places& places)
    : request_(request),
      shard_(shard),
      places_(places),
      found_(find_inputs({request.inputs, request.list, request.base, {places.outputs(), places.state()}})),
      read_files_(request, found_.inputs),
      header_(header_of(request, shard, found_.inputs)),
      tasks_(checked_plan(request, shard, places, found_.inputs, read_files_)),
      log_(places, header_, request.resume),
      most_jobs_(static_cast<std::size_t>(request.jobs > 0 ? request.jobs : threads_in_use(0))),
      threads_(request.threads > 0 ? request.threads : std::max(1, threads_in_use(0) / static_cast<int>(most_jobs_))) {
    if (found_.left_out > 0 && !request.quiet)
        print_note(
            std::cerr,
            fmt::format(
                "files left out, because their suffix is not that of a structure or they are not regular files: {}",
                found_.left_out));
    std::uint64_t weight = 0;
    for (const Task& task : tasks_) {
        const auto found = log_.entries().find(task.input.name);
        if (found != log_.entries().end() && found->second.succeeded && found->second.size == task.input.size) {
            check_radii(task.input.name, found->second);
        } else {
            open_.push_back(&task);
            weight += task.weight;
        }
    }
    outputs_ = open_outputs(places, log_.entries(), read_files_);
    progress_.emplace(resolve(request.progress, request.quiet), std::cerr, open_.size(), weight);
}

RunResult Run::operator()() {
    remove_all_of(places_.done(shard_));
    try {
        const WritingSection section;  // a signal ends the wait below, and what processes have left is removed
        compute_all();
    } catch (...) {
        jobs_.clear();
        progress_->clear();
        remove_all_of(places_.work());
        throw;
    }
    remove_all_of(places_.work());
    progress_->clear();
    outputs_->finish();
    log_.finish(places_.done(shard_), header_, tasks_);
    return sum_up();
}

RunResult Run::sum_up() {
    RunResult result;
    result.inputs = tasks_.size();
    result.done_before = tasks_.size() - open_.size();
    for (const Task& task : tasks_)
        if (const Entry& entry = log_.entries().at(task.input.name); !entry.succeeded)
            result.failed.push_back(without_report(log_.read(entry).result));
    result.seconds = watch_.lap();
    return result;
}

void Run::compute_all() {
    remove_all_of(places_.work());
    while (next_to_start_ < open_.size() || !jobs_.empty()) {
        while (next_to_start_ < open_.size() && running() < most_jobs_) start(next_to_start_++);
        progress_->show();
        wait();
        throw_if_interrupted();
        look_at_processes();
        keep_ended();
    }
}

std::size_t Run::running() const {
    return static_cast<std::size_t>(
        std::count_if(jobs_.begin(), jobs_.end(), [](const auto& job) { return job->process.has_value(); }));
}

void Run::start(std::size_t turn) {
    const Task& task = *open_[turn];
    auto job = std::make_unique<Job>(Job{turn, fmt::format("{}/{}", places_.work(), turn), std::nullopt, {}});
    make_folder(outputs_in(job->folder));
    try {
        if (task.input.member) {
            make_folder(fs::path(input_of(task, job->folder)).parent_path().string());
            extract_member(task.input.path, *task.input.member, input_of(task, job->folder));
        }
        job->process.emplace(words_of(task, job->folder),
                             ProcessLimits{.memory_mb = request_.memory_limit_mb, .seconds = request_.time_limit});
    } catch (const InputError& error) {
        job->end.exit_code = kInputError;
        job->end.messages = std::string(kErrorMark) + error.what();
    }
    jobs_.push_back(std::move(job));
}

/// The command line of a task's process.
std::vector<std::string> Run::words_of(const Task& task, const std::string& folder) const {
    std::vector<std::string> words{fs::read_symlink("/proc/self/exe").string(), request_.command};
    words.insert(words.end(), request_.options.begin(), request_.options.end());
    const bool has_limit =
        std::any_of(words.begin(), words.end(), [](const auto& w) { return w.starts_with("--memory="); });
    if (request_.command == "surface" && request_.memory_limit_mb > 0 && !has_limit)
        words.push_back(fmt::format("--memory={}M", request_.memory_limit_mb));
    const std::string stem = outputs_in(folder) + "/" + fs::path(task.stem).filename().string();
    for (const std::string& ending : request_.endings) words.insert(words.end(), {"-o", stem + ending});
    if (!request_.history.empty()) words.push_back("--history=" + stem + request_.history);
    words.push_back(fmt::format("--threads={}", threads_));
    words.push_back("--report=" + report_in(folder));
    words.insert(words.end(), {"--quiet", "--progress=off", "--", input_of(task, folder)});
    return words;
}

void Run::wait() const {
    std::vector<Process*> processes;
    for (const auto& job : jobs_)
        if (job->process) processes.push_back(&*job->process);
    if (!processes.empty()) Process::wait_for_any(processes, kTick);
}

void Run::look_at_processes() {
    for (const auto& job : jobs_) {
        if (!job->process) continue;
        if (auto end = job->process->poll()) {
            job->end = std::move(*end);
            job->process.reset();
        }
    }
}

/// Records what has ended: as it comes, or in the order of the plan where outputs have one.
void Run::keep_ended() {
    const auto is_kept = [this](const std::unique_ptr<Job>& job) {
        if (job->process || (outputs_->is_ordered() && job->turn != next_to_keep_)) return false;
        keep(*job);
        ++next_to_keep_;
        return true;
    };
    std::sort(jobs_.begin(), jobs_.end(), [](const auto& a, const auto& b) { return a->turn < b->turn; });
    jobs_.erase(std::remove_if(jobs_.begin(), jobs_.end(), is_kept), jobs_.end());
}

void Run::keep(const Job& job) {
    const Task& task = *open_[job.turn];
    Record record = record_of(task, job.end, job.folder, request_.time_limit);
    if (has_outputs(job.end)) record.result["outputs"] = outputs_->take(outputs_in(job.folder), task);
    record.archive_end = outputs_->size();
    log_.append(record);
    progress_->count(record.succeeded(), task.weight);
    remove_all_of(job.folder);
    check_radii(task.input.name, log_.entries().at(task.input.name));
}

void Run::check_radii(const std::string& name, const Entry& entry) {
    if (request_.may_mix_radii || entry.radii.empty()) return;
    radii_.emplace(entry.radii, name);
    if (radii_.size() > 1) refuse_mixed_radii(radii_);
}

}  // namespace meniscus::cli::batch
