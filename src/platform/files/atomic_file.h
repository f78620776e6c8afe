// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A file that appears whole or not at all.
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

#include "platform/files/descriptor_writer.h"
#include "platform/files/digits.h"

namespace meniscus {

/// Removes the temporary files of every AtomicFile that has not been committed: for programs that a signal ends. May be
/// called by a signal handler; nothing may be written afterwards.
void remove_temporary_files() noexcept;

/// The path under which writers that know a format by its suffix write to standard output: "/dev/stdout.ply".
std::string standard_output_as(const std::string& format);

/// Whether a path is one that standard_output_as() gives, or /dev/stdout itself.
bool is_standard_output(const std::string& path);

/// "PATH: there is no folder 'X'; create it first" for a file in a folder that is not there, else empty.
std::string missing_folder(const std::string& path);

/// Writes to a temporary name in the folder of `path`; commit() gives it its real name.
///
/// An older file stays as it was until then, and for good if commit() is never reached: the destructor removes the
/// temporary file. A link is followed, so the file it points to is replaced and not the link. What is there already and
/// is not a regular file (a device, a pipe, /dev/stdout) is written to directly, and so is /dev/stdout.SUFFIX.
/// throws   OutputError "PATH: cannot be written: reason" from every function, or missing_folder() from the first
class AtomicFile {
public:
    explicit AtomicFile(std::string path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Tells how many bytes will follow: found in one piece they are quicker to write, and a full disk shows at once.
    void reserve(std::size_t size);

    void write(std::string_view text) { append(text.data(), text.size()); }
    void write(char c) { append(&c, 1); }

    /// As digits_of says.
    template <class Number>
    void number(Number value) {
        Digits digits;
        write(digits_of(value, digits));
    }

    /// The bytes of a value as they are in memory.
    template <class T>
    void bytes(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        append(reinterpret_cast<const char*>(&value), sizeof value);
    }

    /// Writes what is left; afterwards only commit() can follow, which then can hardly fail.
    void finish();
    void commit();

private:
    static constexpr std::size_t kBufferSize = std::size_t{1} << 18U;

    void open_directly(int descriptor);
    void open_temporary();
    void append(const char* data, std::size_t size) {
        if (size > kBufferSize - used_) return append_over_the_end(data, size);
        std::memcpy(buffer_.get() + used_, data, size);
        used_ += size;
    }
    void append_over_the_end(const char* data, std::size_t size);
    void flush();
    void write_out(const char* data, std::size_t size);
    void close_descriptor();
    [[noreturn]] void fail_without_temporary(int error);
    [[noreturn]] void fail(int error) const;

    std::string path_;       // as the caller names it
    std::string target_;     // with links followed
    std::string temporary_;  // empty when written directly
    int noted_ = -1;         // where remove_temporary_files() finds it
    int descriptor_ = -1;
    DescriptorWriter writer_;  // to it
    std::size_t used_ = 0;     // of the buffer
    std::unique_ptr<char[]> buffer_;
};

}  // namespace meniscus
