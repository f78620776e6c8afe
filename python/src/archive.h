// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Results as bytes, and back to the bit: what pickles hold. Bytes of another version are refused.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "fields.h"
#include "meniscus/errors.h"
#include "meniscus/level_set.h"
#include "meniscus/level_set_file.h"
#include "meniscus/measures.h"
#include "meniscus/mesh.h"
#include "meniscus/version.h"

namespace meniscus::python {

/// Types whose memory is their numbers and nothing else: written as one block.
template <class T>
inline constexpr bool kIsBlock = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <>
inline constexpr bool kIsBlock<Vec3> = true;
template <>
inline constexpr bool kIsBlock<SmallVec3> = true;
template <class T, std::size_t N>
inline constexpr bool kIsBlock<std::array<T, N>> = kIsBlock<T>;
template <>
inline constexpr bool kIsBlock<AtomMeasure> = true;
static_assert(sizeof(AtomMeasure) == 5 * sizeof(double));

/// Writes values one after the other. Of a structure, fields() hands over every member.
class ArchiveWriter {
public:
    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }

    std::string take() { return std::move(bytes_); }

private:
    template <class T>
    void put(const T& value) {
        if constexpr (kIsBlock<T>)
            bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
        else
            fields(*this, const_cast<T&>(value));  // NOLINT: nothing is written to it
    }

    void put(const std::string& text) {
        put(std::uint64_t{text.size()});
        bytes_ += text;
    }

    template <class T>
    void put(const std::vector<T>& values) {
        put(std::uint64_t{values.size()});
        if constexpr (kIsBlock<T>)
            bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        else
            for (const T& value : values) put(value);
    }

    template <class T>
    void put(const std::optional<T>& value) {
        put(value.has_value());
        if (value) put(*value);
    }

    void put(const std::map<std::string, std::size_t>& counts) {
        put(std::uint64_t{counts.size()});
        for (const auto& [name, count] : counts) (*this)(name, count);
    }

    void put(const std::shared_ptr<const Measures>& measures) {
        put(measures != nullptr);
        if (measures) put(*measures);
    }

    void put(const std::shared_ptr<const LevelSet>& level_set) {
        put(level_set ? level_set_bytes(*level_set) : std::string());
    }

    std::string bytes_;
};

class ArchiveReader {
public:
    explicit ArchiveReader(std::string_view bytes) : bytes_(bytes) {}

    template <class... Values>
    void operator()(Values&... values) {
        (get(values), ...);
    }

    void finish() const {
        if (!bytes_.empty()) fail();
    }

private:
    [[noreturn]] static void fail() {
        throw InputError("this pickle has been cut off or changed; make the result anew");
    }

    std::string_view take(std::size_t size) {
        if (size > bytes_.size()) fail();
        const std::string_view part = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return part;
    }

    /// How many values follow, each of at least so many bytes.
    std::size_t count(std::size_t smallest) {
        std::uint64_t n = 0;
        get(n);
        if (n > bytes_.size() / smallest) fail();
        return static_cast<std::size_t>(n);
    }

    template <class T>
    void get(T& value) {
        if constexpr (kIsBlock<T>)
            std::memcpy(&value, take(sizeof value).data(), sizeof value);
        else
            fields(*this, value);
    }

    void get(std::string& text) { text = take(count(1)); }

    template <class T>
    void get(std::vector<T>& values) {
        values.resize(count(kIsBlock<T> ? sizeof(T) : 1));
        if constexpr (kIsBlock<T>) {
            const std::string_view block = take(values.size() * sizeof(T));
            if (!block.empty()) std::memcpy(static_cast<void*>(values.data()), block.data(), block.size());
        } else {
            for (T& value : values) get(value);
        }
    }

    template <class T>
    void get(std::optional<T>& value) {
        bool there = false;
        get(there);
        if (there) get(value.emplace());
    }

    void get(std::map<std::string, std::size_t>& counts) {
        for (std::size_t n = count(1); n > 0; --n) {
            std::string name;
            get(name);
            get(counts[name]);
        }
    }

    void get(std::shared_ptr<const Measures>& measures) {
        std::optional<Measures> there;
        get(there);
        if (there) measures = std::make_shared<const Measures>(*std::move(there));
    }

    void get(std::shared_ptr<const LevelSet>& level_set) {
        std::string bytes;
        get(bytes);
        if (!bytes.empty())
            level_set = std::make_shared<const LevelSet>(level_set_from_bytes(bytes, "the level set of this pickle"));
    }

    std::string_view bytes_;
};

/// Of the bytes, whatever the version of Meniscus; it changes with what fields() hand over, and with the
/// states of the classes of Python.
inline constexpr std::uint32_t kArchiveLayout = 5;

template <class T>
std::string archived(const T& value) {
    ArchiveWriter writer;
    writer(std::string(kVersion), kArchiveLayout, value);
    return writer.take();
}

/// throws   InputError for bytes of another version, or ones that have been cut off
template <class T>
T from_archive(std::string_view bytes) {
    ArchiveReader reader(bytes);
    std::string version;
    std::uint32_t layout = 0;
    reader(version, layout);
    if (version != kVersion || layout != kArchiveLayout)
        throw InputError("this was pickled by Meniscus " + version + " (layout " + std::to_string(layout) +
                         "), and this is Meniscus " + kVersion + " (layout " + std::to_string(kArchiveLayout) +
                         "), which reads pickles of its own only; make the result anew");
    T value;
    reader(value);
    reader.finish();
    return value;
}

}  // namespace meniscus::python
