// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/read_files.h"

#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "meniscus/errors.h"

namespace meniscus::cli::batch {

namespace fs = std::filesystem;

namespace {

using FileNumber = std::pair<dev_t, ino_t>;

/// The same for all names of a regular file; nothing if there is none.
std::optional<FileNumber> number_of(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return FileNumber{status.st_dev, status.st_ino};
}

}  // namespace

ReadFiles::ReadFiles(const Request& request, const std::vector<Input>& inputs) {
    const std::string* last = nullptr;  // members of one archive follow each other
    for (const Input& input : inputs) {
        if (last != nullptr && *last == input.path) continue;
        last = &input.path;
        add(input.path, input.member ? "the archive of inputs" : "an input");
    }
    if (!request.list.empty()) add(request.list, "the file of --list");
    for (const std::string& option : request.options)  // --radii=FILE, --sample=NAME=FILE
        for (std::size_t at = option.find('='); at != std::string::npos; at = option.find('=', at + 1))
            add(option.substr(at + 1), "the file of " + option.substr(0, option.find('=')));
}

void ReadFiles::add(const std::string& path, const std::string& what) {
    if (const auto number = number_of(path)) known_.emplace(*number, what);
}

void ReadFiles::refuse_as_output(const std::string& path) const {
    const auto number = number_of(path);
    if (!number) return;
    const auto found = known_.find(*number);
    if (found != known_.end())
        throw UsageError(fmt::format("{}: would overwrite {}; choose another --out", path, found->second));
}

void check_outputs(const Request& request, const Places& places, const std::vector<Task>& tasks,
                   const ReadFiles& read_files) {
    read_files.refuse_as_output(places.results());
    read_files.refuse_as_output(places.times());
    if (places.is_archive()) return read_files.refuse_as_output(places.outputs());
    for (const std::string& ending : request.endings) {
        for (const Task& task : tasks) read_files.refuse_as_output(places.outputs() + "/" + task.stem + ending);
        std::error_code error;
        for (const std::string& word : request.inputs)
            if (names_structure("x" + ending) && fs::is_directory(word, error) &&
                fs::equivalent(word, places.outputs(), error))
                throw UsageError(
                    fmt::format("--out {}: its {} files would be inputs of the next run; choose another folder",
                                request.out, ending));
    }
}

}  // namespace meniscus::cli::batch
