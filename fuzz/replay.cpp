// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Runs a target without libFuzzer, with any compiler: on every file of some folders, and on changed copies of them that
// are the same in every run.
//
// usage: TARGET CHANGES FOLDER ...    CHANGES: changed copies in all
//
// Changes are blind, without regard to what of the code they reach: that is what libFuzzer is for (fuzz/run).
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

std::vector<fs::path> files_of(const std::vector<std::string>& folders) {
    std::vector<fs::path> files;
    for (const std::string& folder : folders)
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

Bytes read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// Where a crash leaves the input that caused it.
class CurrentInput {
public:
    explicit CurrentInput(std::string path) : path_(std::move(path)) {}
    ~CurrentInput() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    CurrentInput(const CurrentInput&) = delete;
    CurrentInput& operator=(const CurrentInput&) = delete;

    void run(const Bytes& bytes) const {
        std::ofstream(path_, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }

private:
    std::string path_;
};

class Changer {
public:
    explicit Changer(const std::vector<Bytes>& seeds) : seeds_(seeds) {}

    Bytes next() {
        Bytes bytes = seeds_[below(seeds_.size())];
        for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(bytes);
        return bytes;
    }

private:
    // Not std::uniform_int_distribution, which libraries implement differently.
    std::size_t below(std::size_t count) { return random_() % std::max<std::size_t>(count, 1); }
    std::uint8_t any() { return static_cast<std::uint8_t>(below(256)); }
    Bytes::difference_type place(const Bytes& bytes) {
        return static_cast<Bytes::difference_type>(below(bytes.size()));
    }

    void change(Bytes& bytes) {
        if (bytes.empty()) return bytes.push_back(any());
        const auto at = bytes.begin() + place(bytes);
        switch (below(5)) {
            case 0:
                *at = any();
                break;
            case 1:
                *at = bytes[below(bytes.size())];
                break;
            case 2:
                bytes.insert(at, any());
                break;
            case 3:
                bytes.erase(at, at + 1 + place(Bytes(std::min<std::size_t>(bytes.end() - at, 32))));
                break;
            default:
                copy_from_another(bytes);
        }
    }

    void copy_from_another(Bytes& bytes) {
        const Bytes& other = seeds_[below(seeds_.size())];
        if (other.empty()) return;
        const auto from = other.begin() + place(other);
        const auto length =
            1 + static_cast<Bytes::difference_type>(below(std::min<std::size_t>(other.end() - from, 64)));
        bytes.insert(bytes.begin() + place(bytes), from, from + std::min(length, other.end() - from));
    }

    const std::vector<Bytes>& seeds_;
    std::mt19937_64 random_{20090301};  // any number, but the same one
};

}  // namespace

int main(int count, char** words) {
    if (count < 3) {
        std::fprintf(stderr, "usage: %s CHANGES FOLDER ...\n", words[0]);
        return 2;
    }
    const fs::path program = words[0];
    const CurrentInput input(program.filename().string() + ".input");
    std::vector<Bytes> seeds;
    const std::vector<std::string> folders(words + 2, words + count);
    for (const fs::path& path : files_of(folders)) {
        seeds.push_back(read(path));
        input.run(seeds.back());
    }
    if (seeds.empty()) {
        std::fprintf(stderr, "no files in the folders given\n");
        return 2;
    }
    Changer changer(seeds);
    const long changes = std::strtol(words[1], nullptr, 10);
    for (long i = 0; i < changes; ++i) input.run(changer.next());
    std::printf("%zu files and %ld changed copies of them\n", seeds.size(), changes);
    return 0;
}
