// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/outputs.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "batch/archive.h"
#include "meniscus/errors.h"

namespace meniscus::cli::batch {

namespace fs = std::filesystem;

namespace {

/// The files of a folder, sorted.
std::vector<std::string> files_in(const std::string& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// The path below the store of a file that belongs to a task.
std::string place_of(const Task& task, const std::string& file) {
    return (fs::path(task.stem).parent_path() / file).generic_string();
}

class FolderStore : public OutputStore {
public:
    FolderStore(std::string root, const std::map<std::string, Entry>& entries, const ReadFiles& read_files)
        : root_(std::move(root)), read_files_(read_files) {
        for (const auto& [name, entry] : entries)
            for (const std::string& output : entry.outputs) owners_[output] = name;
    }

    std::vector<std::string> take(const std::string& folder, const Task& task) override {
        std::vector<std::string> outputs;
        for (const std::string& file : files_in(folder)) outputs.push_back(place_of(task, file));
        for (const std::string& output : outputs)
            if (const auto& [owner, fresh] = owners_.emplace(output, task.input.name);
                !fresh && owner->second != task.input.name)
                throw OutputError(
                    fmt::format("{}: is also an output of {}; give the inputs different names", output, owner->second));
        for (const std::string& output : outputs) read_files_.refuse_as_output((fs::path(root_) / output).string());
        for (const std::string& output : outputs) {
            const fs::path target = fs::path(root_) / output;
            std::error_code error;
            fs::create_directories(target.parent_path(), error);
            if (!error) fs::rename(fs::path(folder) / target.filename(), target, error);
            if (error) throw OutputError(fmt::format("{}: cannot be written: {}", target.string(), error.message()));
        }
        return outputs;
    }

    bool is_ordered() const override { return false; }

private:
    std::string root_;
    const ReadFiles& read_files_;
    std::map<std::string, std::string> owners_;  // output -> input
};

class ArchiveStore : public OutputStore {
public:
    ArchiveStore(const std::string& path, std::int64_t size) : writer_(path, size) {}

    std::vector<std::string> take(const std::string& folder, const Task& task) override {
        std::vector<std::string> outputs;
        for (const std::string& file : files_in(folder)) {
            outputs.push_back(place_of(task, file));
            writer_.add(outputs.back(), (fs::path(folder) / file).string());
        }
        return outputs;
    }

    bool is_ordered() const override { return true; }
    std::int64_t size() const override { return writer_.size(); }
    void finish() override { writer_.finish(); }

private:
    ArchiveWriter writer_;
};

}  // namespace

std::unique_ptr<OutputStore> open_outputs(const Places& places, const std::map<std::string, Entry>& entries,
                                          const ReadFiles& read_files) {
    if (!places.is_archive()) return std::make_unique<FolderStore>(places.outputs(), entries, read_files);
    std::int64_t size = 0;
    for (const auto& [name, entry] : entries) size = std::max(size, entry.archive_end);
    return std::make_unique<ArchiveStore>(places.outputs(), size);
}

}  // namespace meniscus::cli::batch
