// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/read_files.h"

#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "meniscus/errors.h"

namespace meniscus::cli::batch {

namespace fs = std::filesystem;

void ReadFiles::refuse_as_output(const std::string& path) const {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return;
    if (known_.empty()) look_at_all();
    const auto found = known_.find({status.st_dev, status.st_ino});
    if (found != known_.end())
        throw UsageError(fmt::format("{}: would overwrite {}; choose another --out", path, found->second));
}

void ReadFiles::look_at_all() const {
    for (const Input& input : inputs_) add(input.path, input.member ? "the archive of inputs" : "an input");
    if (!request_.list.empty()) add(request_.list, "the file of --list");
    for (const std::string& option : request_.options)  // --radii=FILE, --sample=NAME=FILE
        for (std::size_t at = option.find('='); at != std::string::npos; at = option.find('=', at + 1))
            add(option.substr(at + 1), "the file of " + option.substr(0, option.find('=')));
}

void ReadFiles::add(const std::string& path, const std::string& what) const {
    struct stat status {};
    if (stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode))
        known_.emplace(Number{status.st_dev, status.st_ino}, what);
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
