// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/run.h"

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "batch/archive.h"
#include "batch/inputs.h"
#include "batch/outputs.h"
#include "batch/process.h"
#include "batch/progress.h"
#include "batch/read_files.h"
#include "interrupt.h"
#include "meniscus/errors.h"
#include "meniscus/version.h"
#include "messages.h"
#include "platform/files/own_file.h"
#include "report.h"
#include "structure_run.h"

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

/// As in "ended by SIGSEGV"; its number where the C library has no names.
std::string signal_name(int number) {
#ifdef __GLIBC__
    if (const char* name = sigabbrev_np(number)) return std::string("SIG") + name;
#endif
    return fmt::format("signal {}", number);
}

std::string error_of(const ProcessEnd& end, double time_limit) {
    if (end.timed_out) return fmt::format("took longer than {:g} s", time_limit);
    if (end.signal == SIGKILL) return "ended by SIGKILL, probably because memory ran out";
    if (end.signal != 0) return fmt::format("ended by {}", signal_name(end.signal));
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

/// What a batch is to do, checked.
struct Work {
    std::vector<Task> tasks;  // of this shard
    ordered_json header;
    ReadFiles read_files;
    std::size_t left_out;  // files that are no inputs
};

Work plan_work(const Request& request, const Shard& shard, const Places& places) {
    const FoundInputs found =
        find_inputs({request.inputs, request.list, request.base, {places.outputs(), places.state()}});
    ReadFiles read_files(request, found.inputs);
    std::vector<Task> tasks = plan(found.inputs, shard);
    check_outputs(request, places, tasks, read_files);
    return {std::move(tasks), header_of(request, shard, found.inputs), std::move(read_files), found.left_out};
}

/// A task under way, or one that has ended and is not recorded yet.
struct Job {
    std::size_t turn;
    const Task& task;
    std::string folder;  // of its own
    std::optional<Process> process;
    ProcessEnd end;
};

/// The jobs of a batch: so many processes at a time.
class Jobs {
public:
    /// request   must outlive the jobs
    /// folder    of all that is under way
    Jobs(const Request& request, std::string folder)
        : request_(request),
          folder_(std::move(folder)),
          most_(request.jobs > 0 ? request.jobs : threads_in_use(0)),
          threads_(request.threads > 0 ? request.threads : std::max(1, threads_in_use(0) / most_)) {}

    bool empty() const { return jobs_.empty(); }
    bool has_room() const {
        const auto runs = [](const auto& job) { return job->process.has_value(); };
        return std::count_if(jobs_.begin(), jobs_.end(), runs) < most_;
    }

    void start(std::size_t turn, const Task& task) {
        auto job = std::make_unique<Job>(Job{turn, task, fmt::format("{}/{}", folder_, turn), std::nullopt, {}});
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

    /// Until one may have ended.
    void wait() const {
        std::vector<Process*> processes;
        for (const auto& job : jobs_)
            if (job->process) processes.push_back(&*job->process);
        if (!processes.empty()) Process::wait_for_any(processes, kTick);
    }

    /// Gives those that have ended to `keep`, in their turn, and forgets those that it has kept.
    void take_ended(const std::function<bool(const Job&)>& keep) {
        for (const auto& job : jobs_) {
            if (!job->process) continue;
            if (auto end = job->process->poll()) {
                job->end = std::move(*end);
                job->process.reset();
            }
        }
        std::sort(jobs_.begin(), jobs_.end(), [](const auto& a, const auto& b) { return a->turn < b->turn; });
        std::erase_if(jobs_, [&keep](const auto& job) { return !job->process && keep(*job); });
    }

private:
    /// The command line of a task's process.
    std::vector<std::string> words_of(const Task& task, const std::string& folder) const {
        std::vector<std::string> words{program_file(), request_.command};
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

    const Request& request_;
    std::string folder_;
    int most_;
    int threads_;  // of each process
    std::vector<std::unique_ptr<Job>> jobs_;
};

/// Records what comes of the tasks.
class Recorder {
public:
    /// request, work   must outlive the recorder
    Recorder(const Request& request, const Places& places, const Work& work)
        : request_(request), log_(places, work.header, request.resume) {
        if (work.left_out > 0 && !request.quiet)
            print_note(std::cerr,
                       fmt::format("files left out, because their suffix is not that of a structure or they are not "
                                   "regular files: {}",
                                   work.left_out));
        for (const Task& task : work.tasks) {
            const auto found = log_.entries().find(task.input.name);
            if (found != log_.entries().end() && found->second.succeeded && found->second.size == task.input.size)
                check_radii(task.input.name, found->second);
            else
                open_.push_back(&task);
        }
        outputs_ = open_outputs(places, log_.entries(), work.read_files);
    }

    const Log& log() const { return log_; }
    const std::vector<const Task*>& open() const { return open_; }  ///< tasks to be computed, in their turn

    /// Records a job that has ended: as it comes, or in the order of the plan where outputs have one. False if it is
    /// not its turn.
    bool keep(const Job& job, Progress& progress) {
        if (outputs_->is_ordered() && job.turn != next_) return false;
        Record record = record_of(job.task, job.end, job.folder, request_.time_limit);
        if (has_outputs(job.end)) record.result["outputs"] = outputs_->take(outputs_in(job.folder), job.task);
        record.archive_end = outputs_->size();
        log_.append(record);
        progress.count(record.succeeded(), job.task.weight);
        remove_all_of(job.folder);
        check_radii(job.task.input.name, log_.entries().at(job.task.input.name));
        ++next_;
        return true;
    }

    void finish() { outputs_->finish(); }

private:
    void check_radii(const std::string& name, const Entry& entry) {
        if (request_.may_mix_radii || entry.radii.empty()) return;
        radii_.emplace(entry.radii, name);
        if (radii_.size() > 1) refuse_mixed_radii(radii_);
    }

    const Request& request_;
    Log log_;
    std::vector<const Task*> open_;
    std::unique_ptr<OutputStore> outputs_;
    std::size_t next_ = 0;                      // turn to keep, where outputs are ordered
    std::map<std::string, std::string> radii_;  // set -> an input that has it
};

void compute_all(const Request& request, const std::string& folder, Recorder& recorder, Progress& progress) {
    const std::vector<const Task*>& open = recorder.open();
    Jobs jobs(request, folder);
    for (std::size_t next = 0; next < open.size() || !jobs.empty();) {
        for (; next < open.size() && jobs.has_room(); ++next) jobs.start(next, *open[next]);
        progress.show();
        jobs.wait();
        throw_if_interrupted();
        jobs.take_ended([&](const Job& job) { return recorder.keep(job, progress); });
    }
}

RunResult sum_up(const Work& work, const Recorder& recorder, double seconds) {
    RunResult result{.inputs = work.tasks.size(),
                     .done_before = work.tasks.size() - recorder.open().size(),
                     .failed = {},
                     .seconds = seconds};
    for (const Task& task : work.tasks)
        if (const Entry& entry = recorder.log().entries().at(task.input.name); !entry.succeeded)
            result.failed.push_back(without_report(recorder.log().read(entry).result));
    return result;
}

}  // namespace

RunResult run(const Request& request, const Shard& shard, const Places& places) {
    const Work work = plan_work(request, shard, places);
    Stopwatch watch;
    Recorder recorder(request, places, work);
    Amount all{.inputs = recorder.open().size()};
    for (const Task* task : recorder.open()) all.weight += task->weight;
    Progress progress(resolve(request.progress, request.quiet), std::cerr, all);
    remove_all_of(places.done(shard));
    remove_all_of(places.work());
    try {
        const WritingSection section;  // a signal ends the wait, and what processes have left is removed
        compute_all(request, places.work(), recorder, progress);
    } catch (...) {
        progress.clear();
        remove_all_of(places.work());
        throw;
    }
    remove_all_of(places.work());
    progress.clear();
    recorder.finish();
    recorder.log().finish(places.done(shard), work.header, work.tasks);
    return sum_up(work, recorder, watch.lap());
}

}  // namespace meniscus::cli::batch
