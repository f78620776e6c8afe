// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <exception>
#include <filesystem>
#include <limits>
#include <ostream>
#include <streambuf>
#include <string_view>
#include <system_error>

#include "meniscus/errors.h"
#include "platform/files/atomic_file.h"
#include "platform/files/loaded_library.h"
#include "platform/files/own_file.h"
#include "volume/vdb_module.h"
#include "volume/writers.h"

namespace meniscus {

namespace fs = std::filesystem;

namespace {

constexpr const char* kModule = "meniscus_vdb.so";

// Where the module is in a folder above the program or library: installed, and in the tree of the build.
constexpr std::array kPlaces{"lib/meniscus", "src/volume"};
constexpr int kFoldersUp = 3;

fs::path module_above(const fs::path& file) {
    std::error_code ignored;
    fs::path folder = fs::weakly_canonical(file, ignored);
    for (int i = 0; i < kFoldersUp; ++i) {
        folder = folder.parent_path();
        for (const char* place : kPlaces)
            if (fs::path found = folder / place / kModule; fs::exists(found, ignored)) return found;
    }
    return {};
}

// Of the library that this code is in, or else of the program.
fs::path find_module() {
    const std::string here = file_that_holds(reinterpret_cast<const void*>(&vdb_supported));
    if (fs::path found = module_above(here); !found.empty()) return found;
    return module_above(program_file());
}

// Loaded once, and for good: OpenVDB keeps registers of its own.
VdbWriter* writer() {
    static VdbWriter* const found = []() -> VdbWriter* {
        const fs::path path = find_module();
        if (path.empty()) return nullptr;
        VdbWriter* function = nullptr;
        if (const auto module = LoadedLibrary::load(path.c_str())) module->find(kVdbWriterName, function);
        return function;
    }();
    return found;
}

// A stream into an AtomicFile. Streams swallow what is thrown below them; it is kept.
class FileBuffer : public std::streambuf {
public:
    explicit FileBuffer(AtomicFile& file) : file_(file) {}

    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

protected:
    int_type overflow(int_type c) override {
        const char byte = traits_type::to_char_type(c);
        return xsputn(&byte, 1) == 1 ? c : traits_type::eof();
    }
    std::streamsize xsputn(const char* data, std::streamsize size) override {
        try {
            file_.write(std::string_view(data, static_cast<std::size_t>(size)));
            written_ += size;
            return size;
        } catch (...) {
            error_ = std::current_exception();
            return 0;
        }
    }
    // OpenVDB asks where it is, and goes nowhere.
    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override {
        return offset == 0 && from == std::ios_base::cur ? pos_type(written_) : pos_type(off_type(-1));
    }

private:
    AtomicFile& file_;
    std::streamsize written_ = 0;
    std::exception_ptr error_;
};

void check(const std::string& path, const VolumeGrid& grid) {
    if (!vdb_supported())
        throw UsageError(
            path + ": this build cannot write .vdb; install libopenvdb-dev and build again, or ask for .dx or .mrc");
    if (grid.spacing.x != grid.spacing.y || grid.spacing.x != grid.spacing.z)
        throw UsageError(path + ": a level set has a single spacing, but the grid has several; ask for .dx or .mrc");
    for (const std::size_t count : grid.counts)
        if (count > std::numeric_limits<std::int32_t>::max())
            throw LimitError(
                fmt::format("{}: VDB holds at most 2147483647 nodes along an axis, not {}; write .dx", path, count));
}

}  // namespace

bool vdb_supported() { return writer() != nullptr; }

void write_vdb(const std::string& path, const Volume& volume, VolumeContent content) {
    check(path, volume.grid);
    const std::array<std::string, 2> lines = header_lines(content);
    const char* const of_vdb = "Signed distance to the surface, Angstrom, inside negative";
    AtomicFile file(path);
    FileBuffer buffer(file);
    std::ostream out(&buffer);
    writer()({volume, content, lines[0], content == VolumeContent::Distance ? of_vdb : lines[1]}, out);
    buffer.rethrow();
    file.commit();
}

}  // namespace meniscus
