// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/process.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <limits>
#include <system_error>
#include <utility>

#include "platform/files/child_process.h"

namespace meniscus::cli::batch {

namespace {

constexpr std::size_t kMostMessages = 1U << 16U;  // bytes

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

/// How long it may take to notice the end of a process where the system gives no handle of it.
constexpr double kLook = 0.01;  // seconds

/// Two ends of a pipe that programs started from here do not get.
bool open_pipe(std::array<int, 2>& ends) {
    if (pipe(ends.data()) != 0) return false;
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
    return true;
}

/// In the new process, between fork and exec: only what is safe there.
/// streams   its standard input, output and error
[[noreturn]] void become(char* const* words, const std::array<int, 3>& streams, const ProcessLimits& limits,
                         pid_t parent) {
    if (!end_with_parent() || getppid() != parent) _exit(127);
    if (limits.memory_mb > 0) {
        const rlim_t bytes = static_cast<rlim_t>(limits.memory_mb) << 20U;
        const rlimit limit{bytes, bytes};
        if (setrlimit(RLIMIT_AS, &limit) != 0) _exit(127);
    }
    for (int stream = 0; stream < 3; ++stream)
        if (dup2(streams[static_cast<std::size_t>(stream)], stream) < 0) _exit(127);
    execv(words[0], words);
    _exit(127);
}

}  // namespace

Process::Process(const std::vector<std::string>& words, const ProcessLimits& limits) : limits_(limits) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const Descriptor nothing("/dev/null", O_RDWR);
    std::array<int, 2> ends{};
    if (!nothing.is_open() || !open_pipe(ends)) fail("a process cannot be started");
    errors_ = Descriptor(ends[0]);
    const Descriptor writing(ends[1]);
    if (fcntl(ends[0], F_SETFL, O_NONBLOCK) != 0) fail("a process cannot be started");
    const std::array streams{nothing.number(), nothing.number(), writing.number()};
    const pid_t parent = getpid();
    id_ = fork();
    if (id_ < 0) fail("a process cannot be started");
    if (id_ == 0) become(arguments.data(), streams, limits, parent);
    handle_ = Descriptor(process_handle(id_));
}

Process::Process(Process&& other) noexcept
    : id_(std::exchange(other.id_, -1)),
      handle_(std::move(other.handle_)),
      errors_(std::move(other.errors_)),
      limits_(other.limits_),
      start_(other.start_),
      timed_out_(other.timed_out_),
      messages_(std::move(other.messages_)) {}

Process::~Process() {
    if (id_ < 0) return;
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
}

void Process::wait_for_any(const std::vector<Process*>& processes, double seconds) {
    std::vector<pollfd> watched;
    watched.reserve(2 * processes.size());
    for (const Process* process : processes) {
        if (process->handle_.is_open())
            watched.push_back({process->handle_.number(), POLLIN, 0});
        else
            seconds = std::min(seconds, kLook);
        if (process->errors_.is_open()) watched.push_back({process->errors_.number(), POLLIN, 0});
        seconds = std::min(seconds, process->seconds_left());
    }
    ::poll(watched.data(), watched.size(), static_cast<int>(std::ceil(1000.0 * std::max(0.0, seconds))));
}

std::optional<ProcessEnd> Process::poll() {
    if (!timed_out_ && seconds_left() <= 0.0) {
        timed_out_ = true;
        kill(id_, SIGKILL);
    }
    read_messages();
    int status = 0;
    rusage usage{};
    const pid_t ended = wait4(id_, &status, WNOHANG, &usage);
    if (ended == 0) return std::nullopt;
    read_messages();
    id_ = -1;
    const std::chrono::duration<double> wall = Clock::now() - start_;
    return ProcessEnd{.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0,
                      .signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0,
                      .timed_out = timed_out_,
                      .wall_seconds = wall.count(),
                      .cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime),
                      .messages = std::move(messages_)};
}

void Process::read_messages() {
    std::array<char, 4096> block;
    while (errors_.is_open()) {
        const ssize_t count = read(errors_.number(), block.data(), block.size());
        if (count < 0) return;
        if (count == 0) return errors_.close();
        messages_.append(block.data(), static_cast<std::size_t>(count));
        if (messages_.size() > kMostMessages) messages_.erase(0, messages_.size() - kMostMessages);
    }
}

double Process::seconds_left() const {
    if (limits_.seconds <= 0.0) return std::numeric_limits<double>::infinity();
    return limits_.seconds - std::chrono::duration<double>(Clock::now() - start_).count();
}

}  // namespace meniscus::cli::batch
