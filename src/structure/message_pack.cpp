// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/message_pack.h"

#include "core/bits.h"

namespace meniscus::reading {
namespace {

constexpr int kDeepest = 32;  // BinaryCIF needs eleven

class Unpacker {
public:
    explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

    PackedValue whole() {
        PackedValue value = next(0);
        if (position_ < bytes_.size()) throw DamagedData("more bytes than its contents have", position_);
        return value;
    }

private:
    using Kind = PackedValue::Kind;

    PackedValue next(int depth) {
        if (depth > kDeepest) throw DamagedData("values nested too deeply", position_);
        PackedValue value;
        value.at = position_;
        const auto first = static_cast<std::uint8_t>(take(1)[0]);
        if (first < 0x80)
            set(value, first);
        else if (first >= 0xe0)
            set(value, static_cast<std::int8_t>(first));
        else if (first < 0xc0)
            read_short(value, first, depth);
        else if (first < 0xca || (first >= 0xd4 && first <= 0xd8))
            read_plain(value, first);
        else if (first < 0xd4)
            read_number(value, first);
        else
            read_long(value, first, depth);
        return value;
    }

    // Maps, arrays and texts whose length is part of their first byte.
    void read_short(PackedValue& value, std::uint8_t first, int depth) {
        if (first < 0x90)
            read_items(value, Kind::Map, first & 0x0fU, depth);
        else if (first < 0xa0)
            read_items(value, Kind::Array, first & 0x0fU, depth);
        else
            read_text(value, Kind::Text, first & 0x1fU);
    }

    // Nil, false, true, bytes, and extensions, which BinaryCIF has none of.
    void read_plain(PackedValue& value, std::uint8_t first) {
        if (first == 0xc1) throw DamagedData("a byte that MessagePack does not use", value.at);
        if (first == 0xc2 || first == 0xc3) {
            set(value, first - 0xc2);
            value.kind = Kind::Boolean;
        } else if (first >= 0xc4 && first <= 0xc6) {
            read_text(value, Kind::Bytes, unsigned_of(1U << (first - 0xc4U)));
        } else if (first >= 0xc7 && first <= 0xc9) {
            read_text(value, Kind::Extension, 1 + unsigned_of(1U << (first - 0xc7U)));
        } else if (first >= 0xd4) {
            read_text(value, Kind::Extension, 1 + (1U << (first - 0xd4U)));
        }
    }

    void read_number(PackedValue& value, std::uint8_t first) {
        if (first < 0xcc) {
            value.kind = Kind::Real;
            value.real = first == 0xca ? double{bit_cast<float>(static_cast<std::uint32_t>(unsigned_of(4)))}
                                       : bit_cast<double>(unsigned_of(8));
        } else if (first < 0xd0) {
            const std::uint64_t number = unsigned_of(1U << (first - 0xccU));
            set(value, static_cast<std::int64_t>(number));
            if (number > INT64_MAX) throw DamagedData("a number out of range", value.at);
        } else {
            const unsigned size = 1U << (first - 0xd0U);
            const unsigned unused = 64 - 8 * size;  // bits: shifted out and back, the sign spreads over them
            set(value, static_cast<std::int64_t>(unsigned_of(size) << unused) >> unused);
        }
    }

    void read_long(PackedValue& value, std::uint8_t first, int depth) {
        if (first <= 0xdb)
            read_text(value, Kind::Text, unsigned_of(1U << (first - 0xd9U)));
        else if (first <= 0xdd)
            read_items(value, Kind::Array, unsigned_of(2U << (first - 0xdcU)), depth);
        else
            read_items(value, Kind::Map, unsigned_of(2U << (first - 0xdeU)), depth);
    }

    static void set(PackedValue& value, std::int64_t number) {
        value.kind = Kind::Integer;
        value.integer = number;
        value.real = static_cast<double>(number);
    }

    void read_text(PackedValue& value, Kind kind, std::uint64_t size) {
        value.kind = kind;
        value.text = take(size);
    }

    void read_items(PackedValue& value, Kind kind, std::uint64_t count, int depth) {
        value.kind = kind;
        if (kind == Kind::Map) count *= 2;
        // Each takes a byte at least.
        if (count > bytes_.size() - position_) throw_early();
        // A count alone reserves nothing: lists in lists could claim the same bytes again and again.
        for (std::uint64_t i = 0; i < count; ++i) value.items.push_back(next(depth + 1));
        value.items.shrink_to_fit();
    }

    std::uint64_t unsigned_of(unsigned size) {
        std::uint64_t number = 0;
        for (const char c : take(size)) number = number << 8U | static_cast<std::uint8_t>(c);
        return number;
    }

    std::string_view take(std::uint64_t size) {
        if (size > bytes_.size() - position_) throw_early();
        const std::string_view taken = bytes_.substr(position_, size);
        position_ += size;
        return taken;
    }

    [[noreturn]] void throw_early() const { throw DamagedData("it ends too early", bytes_.size()); }

    std::string_view bytes_;
    std::size_t position_ = 0;
};

}  // namespace

const PackedValue* PackedValue::find(std::string_view key) const {
    if (kind != Kind::Map) return nullptr;
    for (std::size_t i = 0; i + 1 < items.size(); i += 2) {
        if (items[i].is_text() && items[i].text == key) return &items[i + 1];
    }
    return nullptr;
}

PackedValue unpack(std::string_view bytes) { return Unpacker(bytes).whole(); }

}  // namespace meniscus::reading
