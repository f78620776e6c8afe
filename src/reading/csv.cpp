// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/csv.h"

#include <algorithm>
#include <array>

namespace meniscus::reading {
namespace {

constexpr std::string_view kSeparators = ",;\t";  // of as many in the header, the first

char separator_of(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of('\n'), text.size()));
    const std::string_view names = text.substr(0, text.find('\n'));
    std::array<std::size_t, 3> counts{};  // outside quotes
    bool is_quoted = false;
    for (const char c : names) {
        if (c == '"') is_quoted = !is_quoted;
        const std::size_t which = kSeparators.find(c);
        if (!is_quoted && which != std::string_view::npos) ++counts[which];
    }
    return kSeparators[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
}

class CsvReader {
public:
    CsvReader(std::string_view text, const std::string& file)
        : text_(text), file_(file), separator_(separator_of(text)) {}

    std::vector<CsvRow> rows() {
        std::vector<CsvRow> all;
        while (position_ < text_.size()) {
            CsvRow row = next_row();
            if (row.size() > 1 || !row.front().text.empty()) all.push_back(std::move(row));
        }
        return all;
    }

private:
    bool at(char c) const { return position_ < text_.size() && text_[position_] == c; }
    Place here() const { return {line_, position_ - line_begin_ + 1}; }

    CsvRow next_row() {
        CsvRow row{next_cell()};
        while (at(separator_)) {
            ++position_;
            row.push_back(next_cell());
        }
        end_line();
        return row;
    }

    void end_line() {
        ++position_;
        ++line_;
        line_begin_ = position_;
    }

    CsvCell next_cell() {
        CsvCell cell{.text = {}, .place = here()};
        if (at('"')) {
            cell.text = quoted(cell.place);
            if (position_ < text_.size() && !at(separator_) && !at('\n'))
                fail_at(file_, here(), "text follows the closing quote; write \"\" for a quote in the text");
        } else {
            const std::size_t end =
                std::min(text_.find_first_of(std::string{separator_, '\n'}, position_), text_.size());
            cell.text = text_.substr(position_, end - position_);
            position_ = end;
        }
        return cell;
    }

    std::string quoted(Place begin) {
        std::string text;
        for (++position_; position_ < text_.size(); ++position_) {
            if (at('"')) {
                ++position_;
                if (!at('"')) return text;
            }
            text += text_[position_];
            if (!at('\n')) continue;
            ++line_;
            line_begin_ = position_ + 1;
        }
        fail_at(file_, begin, "the quote is not closed");
    }

    std::string_view text_;
    const std::string& file_;
    char separator_;
    std::size_t position_ = 0;
    std::size_t line_ = 1;
    std::size_t line_begin_ = 0;
};

}  // namespace

std::vector<CsvRow> read_csv(std::string_view text, const std::string& file) { return CsvReader(text, file).rows(); }

}  // namespace meniscus::reading
