// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/cif_locate.h"

#include "structure/element.h"

namespace meniscus::reading {
namespace {

enum class TokenKind { End, Tag, Loop, Block, Value };

struct Token {
    TokenKind kind = TokenKind::End;
    std::string_view text;
    Place place;
};

bool is_white_space(char c) { return c == ' ' || c == '\t' || c == '\n'; }

// Splits CIF 1.1 text: words, quoted values, text fields between lines that begin with a semicolon, comments.
class Tokens {
public:
    explicit Tokens(std::string_view text) : text_(text) {}

    Token next() {
        skip_blanks_and_comments();
        if (position_ >= text_.size()) return {};
        const Place place{line_, position_ - line_start_ + 1};
        const char first = text_[position_];
        if (first == ';' && position_ == line_start_) return {TokenKind::Value, text_field(), place};
        if (first == '\'' || first == '"') return {TokenKind::Value, quoted_value(first), place};
        const std::string_view word = bare_word();
        return {kind_of(word), word, place};
    }

private:
    static TokenKind kind_of(std::string_view word) {
        if (word[0] == '_') return TokenKind::Tag;
        const std::string start = upper_case(word.substr(0, 5));
        if (start == "LOOP_") return TokenKind::Loop;
        if (start == "DATA_" || start == "SAVE_") return TokenKind::Block;
        return TokenKind::Value;
    }

    char advance() {
        const char c = text_[position_++];
        if (c == '\n') {
            ++line_;
            line_start_ = position_;
        }
        return c;
    }

    void skip_blanks_and_comments() {
        while (position_ < text_.size()) {
            if (text_[position_] == '#') {
                position_ = std::min(text_.find('\n', position_), text_.size());
            } else if (is_white_space(text_[position_])) {
                advance();
            } else {
                return;
            }
        }
    }

    std::string_view bare_word() {
        const std::size_t begin = position_;
        while (position_ < text_.size() && !is_white_space(text_[position_])) ++position_;
        return text_.substr(begin, position_ - begin);
    }

    // A quote ends a value only if a blank follows it.
    std::string_view quoted_value(char quote) {
        const std::size_t begin = position_++;
        while (position_ < text_.size()) {
            const char c = advance();
            if (c == quote && (position_ == text_.size() || is_white_space(text_[position_]))) break;
        }
        return text_.substr(begin, position_ - begin);
    }

    std::string_view text_field() {
        const std::size_t begin = position_++;
        while (position_ < text_.size()) {
            const bool at_line_start = advance() == '\n';
            if (at_line_start && position_ < text_.size() && text_[position_] == ';') {
                ++position_;
                break;
            }
        }
        return text_.substr(begin, position_ - begin);
    }

    std::string_view text_;
    std::size_t position_ = 0;
    std::size_t line_ = 1;
    std::size_t line_start_ = 0;
};

// Follows the tokens and knows to which tag and row each value belongs.
class Finder {
public:
    Finder(std::string_view tag, std::size_t row) : tag_(upper_case(tag)), row_(row) {}

    // True if the token is the value looked for.
    bool take(const Token& token) {
        if (token.kind == TokenKind::Value) return take_value();
        if (token.kind == TokenKind::Tag && in_loop_ && values_ == 0) {
            if (upper_case(token.text) == tag_) wanted_ = tags_;
            ++tags_;
            return false;
        }
        in_loop_ = token.kind == TokenKind::Loop;
        values_ = 0;
        tags_ = token.kind == TokenKind::Tag ? 1 : 0;
        wanted_ = token.kind == TokenKind::Tag && upper_case(token.text) == tag_ ? 0 : kNone;
        return false;
    }

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    bool take_value() {
        const std::size_t index = values_++;
        return wanted_ != kNone && tags_ > 0 && index % tags_ == wanted_ && index / tags_ == (in_loop_ ? row_ : 0);
    }

    std::string tag_;
    std::size_t row_;
    bool in_loop_ = false;
    std::size_t tags_ = 0;
    std::size_t values_ = 0;
    std::size_t wanted_ = kNone;
};

}  // namespace

Place locate_cif_value(std::string_view text, std::string_view tag, std::size_t row) {
    Tokens tokens(text);
    Finder finder(tag, row);
    for (Token token = tokens.next(); token.kind != TokenKind::End; token = tokens.next()) {
        if (finder.take(token)) return token.place;
    }
    return {};
}

}  // namespace meniscus::reading
