// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// OpenDX as APBS writes it: a header of lines, then numbers in any arrangement, then lines without use.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "reading/numbers.h"
#include "reading/text.h"
#include "volume/byte_source.h"
#include "volume/readers.h"

namespace meniscus {
namespace {

using reading::Place;
using reading::shown;

constexpr std::size_t kLongestLine = 4096;  // of the header
constexpr std::size_t kLongestWord = 64;    // of a number
constexpr std::uint64_t kMostNodes = std::uint64_t{1} << 48U;

struct Word {
    std::string text;  // without quotes
    Place place;
};

bool is_white_space(int c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

class DxReader {
public:
    explicit DxReader(const std::string& path) : source_(path) {}

    Volume read(VolumePart part) {
        read_header();
        if (part == VolumePart::All) {
            read_values();
            check_rest();
        }
        return std::move(volume_);
    }

private:
    [[noreturn]] void fail(Place place, const std::string& message) const {
        reading::fail_at(source_.path(), place, message);
    }
    [[noreturn]] void fail(const Word& word, const std::string& message) const { fail(word.place, message); }

    int take() {
        const int c = source_.get();
        if (c == '\n')
            here_ = {here_.line + 1, 1};
        else
            ++here_.column;
        return c;
    }

    // The words of the next line, none for an empty line or a comment; false at the end of the file.
    bool next_line() {
        words_.clear();
        if (source_.peek() == ByteSource::kEnd) return false;
        const Place start = here_;
        std::string line;
        for (int c = take(); c != '\n' && c != ByteSource::kEnd; c = take()) {
            if (line.size() == kLongestLine)
                fail(start, "a line of more than 4096 bytes; this is not an OpenDX header");
            line.push_back(static_cast<char>(c));
        }
        split(line, start.line);
        line_end_ = {start.line, line.size() + 1};
        return true;
    }

    void split(const std::string& line, std::size_t number) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (is_white_space(line[i])) continue;
            if (line[i] == '#') return;
            const bool quoted = line[i] == '"';
            const std::size_t begin = quoted ? i + 1 : i;
            std::size_t end = quoted ? std::min(line.find('"', begin), line.size()) : begin;
            while (!quoted && end < line.size() && !is_white_space(line[end])) ++end;
            words_.push_back({line.substr(begin, end - begin), {number, i + 1}});
            i = end;
        }
    }

    const Word& word(std::size_t i, const char* what) const {
        if (i >= words_.size()) fail(line_end_, fmt::format("{} is missing; the line ends too early", what));
        return words_[i];
    }

    double number(std::size_t i, const char* what) const {
        const Word& w = word(i, what);
        const std::optional<double> value = reading::whole_number<double>(w.text);
        if (!value || !std::isfinite(*value))
            fail(w, fmt::format("{} {} is not a finite number; correct it", what, shown(w.text)));
        return *value;
    }

    std::size_t count(std::size_t i, const char* what) const {
        const Word& w = word(i, what);
        const auto value = reading::whole_number<std::uint64_t>(w.text);
        const std::uint64_t most = std::min<std::uint64_t>(kMostNodes, std::numeric_limits<std::size_t>::max());
        if (!value || *value == 0 || *value > most)
            fail(w, fmt::format("{} {} is not a number of nodes; correct it", what, shown(w.text)));
        return static_cast<std::size_t>(*value);
    }

    bool begins_with(const char* text) const { return words_[0].text == text; }

    void read_header() {
        while (next_line()) {
            if (words_.empty() || begins_with("attribute")) continue;
            if (begins_with("origin"))
                read_origin();
            else if (begins_with("delta"))
                read_delta();
            else if (begins_with("object") && read_object())
                return;
            else if (!begins_with("object"))
                fail(words_[0],
                     fmt::format("{} cannot begin a line of an OpenDX header; expected object, origin or delta",
                                 shown(words_[0].text)));
        }
        fail(here_, "the file ends before its data; it is cut off or not an OpenDX grid, fetch or write it again");
    }

    void read_origin() {
        volume_.grid.origin = {number(1, "origin x"), number(2, "origin y"), number(3, "origin z")};
        has_origin_ = true;
    }

    void read_delta() {
        static constexpr std::array kNames{"delta x", "delta y", "delta z"};
        if (deltas_ == 3) fail(words_[0], "a fourth delta; a grid has three");
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double value = number(axis + 1, kNames[axis]);
            if (axis != deltas_ && value != 0.0)
                fail(words_[axis + 1], fmt::format("{} {} makes a skew grid, which is not supported; steps must be "
                                                   "along x, y and z, in this order",
                                                   kNames[axis], shown(words_[axis + 1].text)));
            if (axis != deltas_) continue;
            if (!(value > 0.0))
                fail(words_[axis + 1], fmt::format("{} {} is not positive; write the grid with positive steps",
                                                   kNames[axis], shown(words_[axis + 1].text)));
            steps_[axis] = value;
        }
        ++deltas_;
    }

    // True for the array of data, behind which the values follow.
    bool read_object() {
        if (word(2, "class").text != "class") fail(words_[2], "expected 'class' here; correct the line");
        const std::string kind = word(3, "the class").text;
        if (kind == "gridpositions")
            read_counts();
        else if (kind == "gridconnections")
            check_connections();
        else if (kind == "array")
            begin_data();
        else
            fail(words_[3],
                 fmt::format("class {} cannot come before the data; expected gridpositions, gridconnections or array",
                             shown(kind)));
        return kind == "array";
    }

    std::array<std::size_t, 3> counts_of_line() const {
        if (word(4, "counts").text != "counts") fail(words_[4], "expected 'counts' here; correct the line");
        return {count(5, "count along x"), count(6, "count along y"), count(7, "count along z")};
    }

    void read_counts() {
        if (has_counts_) fail(words_[0], "a second grid; write one grid per file");
        volume_.grid.counts = counts_of_line();
        std::uint64_t nodes = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (volume_.grid.counts[axis] > kMostNodes / nodes)
                fail(words_[5 + axis], "more nodes than any file can have; correct the counts");
            nodes *= volume_.grid.counts[axis];
        }
        has_counts_ = true;
    }

    void check_connections() const {
        if (words_.size() > 4 && has_counts_ && counts_of_line() != volume_.grid.counts)
            fail(words_[4], "the counts of connections and positions differ; correct one of them");
    }

    void begin_data() {
        if (!has_counts_)
            fail(words_[0], "data without 'class gridpositions counts' before them; write that line first");
        if (!has_origin_) fail(words_[0], "data without an origin before them; write that line first");
        if (deltas_ < 3)
            fail(words_[0], fmt::format("data with {} of 3 deltas before them; write these lines first", deltas_));
        volume_.grid.spacing = {steps_[0], steps_[1], steps_[2]};
        std::optional<std::uint64_t> items;
        for (std::size_t i = 4; i < words_.size(); ++i) {
            const std::string& text = words_[i].text;
            if (text == "lsb" || text == "msb" || text == "binary" || text == "ieee")
                fail(words_[i], "binary data are not supported; write them as text");
            if (text == "rank" && word(i + 1, "the rank").text != "0")
                fail(words_[i + 1], "data with several values per node; write one (rank 0)");
            if (text == "items") items = count(i + 1, "number of items");
            if (items && text == "items" && *items != volume_.grid.size())
                fail(words_[i + 1],
                     fmt::format("{} items for a grid of {} nodes; correct one of them", *items, volume_.grid.size()));
        }
        if (!items) fail(line_end_, "'items' with the number of values is missing; add it");
        if (words_[words_.size() - 2].text != "data" || words_.back().text != "follows")
            fail(line_end_, "the data must follow in the same file; expected 'data follows' here");
    }

    void read_values() {
        const std::size_t items = volume_.grid.size();
        if (source_.most() / 2 < items)
            fail(here_,
                 fmt::format("the file is too short for {} values; it is cut off, fetch or write it again", items));
        volume_.values.resize(items);
        for (std::size_t i = 0; i < items; ++i) volume_.values[i] = next_value(i);
    }

    void skip_blanks() {
        for (int c = source_.peek(); is_white_space(c) || c == '#'; c = source_.peek()) {
            if (c == '#')
                while (source_.peek() != '\n' && source_.peek() != ByteSource::kEnd) take();
            else
                take();
        }
    }

    float next_value(std::size_t index) {
        skip_blanks();
        const Place place = here_;
        std::array<char, kLongestWord> digits;
        std::size_t size = 0;
        for (int c = source_.peek(); c != ByteSource::kEnd && !is_white_space(c) && size < digits.size();
             c = source_.peek())
            digits[size++] = static_cast<char>(take());
        const std::string_view text(digits.data(), size);
        if (text.empty() || text == "attribute" || text == "object" || text == "component")
            fail(place, fmt::format("the data end after {} of {} values; the file is cut off, fetch or write it again",
                                    index, volume_.values.size()));
        const std::optional<double> value = reading::whole_number<double>(text);
        if (!value || !(std::abs(*value) <= static_cast<double>(std::numeric_limits<float>::max())))
            fail(place, fmt::format("value {} is not a number within single precision; correct it", shown(text)));
        return static_cast<float>(*value);
    }

    // What follows names parts and is not needed; a number more would mean that the counts are wrong.
    void check_rest() {
        while (next_line()) {
            if (words_.empty()) continue;
            if (reading::whole_number<double>(words_[0].text))
                fail(words_[0],
                     fmt::format("more values than the {} of the grid; correct the counts", volume_.values.size()));
        }
    }

    ByteSource source_;
    Place here_;
    Place line_end_;
    std::vector<Word> words_;  // of the line
    Volume volume_;
    std::array<double, 3> steps_{};
    std::size_t deltas_ = 0;
    bool has_origin_ = false;
    bool has_counts_ = false;
};

}  // namespace

Volume read_dx(const std::string& path, VolumePart part) { return DxReader(path).read(part); }

}  // namespace meniscus
