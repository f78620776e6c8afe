// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "meniscus/errors.h"

namespace meniscus {
namespace {

// Names of temporary files, where a signal handler can read them: it may neither lock nor allocate.
class NotedNames {
public:
    /// Returns the place, or -1 if there is none left or the name is too long: such a file is not removed by signals.
    int add(const std::string& name) {
        if (name.size() >= kLongest) return -1;
        for (int i = 0; i < kPlaces; ++i) {
            int free = kFree;
            if (!states_[i].compare_exchange_strong(free, kFilling)) continue;
            std::memcpy(names_[i], name.c_str(), name.size() + 1);
            states_[i] = kNoted;
            return i;
        }
        return -1;
    }
    void drop(int place) {
        if (place >= 0) states_[place] = kFree;
    }
    void unlink_all() const {
        for (int i = 0; i < kPlaces; ++i)
            if (states_[i] == kNoted) ::unlink(names_[i]);
    }

private:
    static constexpr int kPlaces = 16;
    static constexpr std::size_t kLongest = 4096;
    static constexpr int kFree = 0;
    static constexpr int kFilling = 1;
    static constexpr int kNoted = 2;
    static_assert(std::atomic<int>::is_always_lock_free);

    std::atomic<int> states_[kPlaces]{};
    char names_[kPlaces][kLongest]{};
};

NotedNames noted_names;

constexpr std::string_view kStandardOutput = "/dev/stdout";

constexpr int kAttempts = 100;  // at a temporary name that nobody else uses

// The standard streams under the names they have in /dev; -1 for other paths. They are written through the descriptor
// that is open, because opening their names again would start at the beginning of a file they were sent to.
int standard_stream(const std::string& path) {
    if (is_standard_output(path)) return STDOUT_FILENO;
    if (path == "/dev/stderr" || path == "/dev/fd/2") return STDERR_FILENO;
    return -1;
}

std::string follow_links(const std::string& path) {
    const std::unique_ptr<char, decltype(&std::free)> resolved(::realpath(path.c_str(), nullptr), &std::free);
    return resolved ? std::string(resolved.get()) : path;
}

std::string temporary_name_beside(const std::string& target) {
    static std::atomic<unsigned> counter{0};
    const std::size_t slash = target.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : target.substr(0, slash + 1);
    return folder + ".meniscus-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp";
}

}  // namespace

std::string standard_output_as(const std::string& format) { return std::string(kStandardOutput) + "." + format; }

bool is_standard_output(const std::string& path) {
    const std::size_t dot = std::min(path.rfind('.'), path.size());
    return path == "/dev/fd/1" || path.substr(0, dot) == kStandardOutput;
}

std::string missing_folder(const std::string& path) {
    const std::filesystem::path parent = std::filesystem::path(path).parent_path();
    std::error_code error;
    if (parent.empty() || std::filesystem::is_directory(parent, error)) return "";
    if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory) return "";
    return path + ": there is no folder '" + parent.string() + "'; create it first";
}

void remove_temporary_files() noexcept { noted_names.unlink_all(); }

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)), buffer_(new char[kBufferSize]) {
    struct stat found {};
    const bool exists = ::stat(path_.c_str(), &found) == 0;
    if (const int stream = standard_stream(path_); stream >= 0)
        open_directly(::dup(stream));
    else if (exists && S_ISDIR(found.st_mode))
        fail(EISDIR);
    else if (exists && !S_ISREG(found.st_mode))
        open_directly(::open(path_.c_str(), O_WRONLY | O_CLOEXEC));
    else if (exists && ::access(path_.c_str(), W_OK) != 0)
        fail(errno);
    else
        open_temporary();
    // A file that is replaced keeps its permissions; that this may fail on some file systems does not matter.
    if (exists && !temporary_.empty() && ::fchmod(descriptor_, found.st_mode & 07777U) != 0) errno = 0;
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    noted_names.drop(noted_);
}

void AtomicFile::open_directly(int descriptor) {
    if (descriptor < 0) fail(errno);
    descriptor_ = descriptor;
    writer_ = DescriptorWriter(descriptor_, false);
}

void AtomicFile::open_temporary() {
    target_ = follow_links(path_);
    int error = EEXIST;
    for (int attempt = 0; attempt < kAttempts && error == EEXIST; ++attempt) {
        const std::string name = temporary_name_beside(target_);
        noted_names.drop(noted_);
        noted_ = noted_names.add(name);  // before it is there, or a signal between both would leave it
        descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        error = descriptor_ < 0 ? errno : 0;
        if (error == 0) temporary_ = name;
    }
    if (error != 0) fail_without_temporary(error);
    writer_ = DescriptorWriter(descriptor_, true);
}

void AtomicFile::reserve([[maybe_unused]] std::size_t size) {
#if defined(FALLOC_FL_KEEP_SIZE) && !defined(__EMSCRIPTEN__)
    if (temporary_.empty()) return;
    const int result = ::fallocate(descriptor_, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(size));
    if (result != 0 && errno == ENOSPC) fail(errno);  // other errors: the file system cannot do this
#endif
}

void AtomicFile::append_over_the_end(const char* data, std::size_t size) {
    flush();
    if (size > kBufferSize) return write_out(data, size);
    append(data, size);
}

void AtomicFile::flush() { write_out(buffer_.get(), std::exchange(used_, 0)); }

void AtomicFile::write_out(const char* data, std::size_t size) {
    if (const int error = writer_.write(data, size); error != 0) fail(error);
}

void AtomicFile::close_descriptor() {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0 && errno != EINTR) fail(errno);
}

void AtomicFile::finish() {
    if (descriptor_ < 0) return;
    flush();
    if (const int error = writer_.finish(); error != 0) fail(error);
    close_descriptor();
}

void AtomicFile::commit() {
    finish();
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    temporary_.clear();
    noted_names.drop(std::exchange(noted_, -1));
}

// From the constructor: there will be no destructor.
void AtomicFile::fail_without_temporary(int error) {
    noted_names.drop(std::exchange(noted_, -1));
    fail(error);
}

void AtomicFile::fail(int error) const {
    if (const std::string text = missing_folder(path_); error == ENOENT && !text.empty()) throw OutputError(text);
    throw OutputError((is_standard_output(path_) ? "standard output" : path_) +
                      ": cannot be written: " + std::generic_category().message(error));
}

}  // namespace meniscus
