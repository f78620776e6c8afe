// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/bits.h"
#include "meniscus/errors.h"
#include "volume/byte_source.h"
#include "volume/mrc_header.h"
#include "volume/readers.h"

namespace meniscus {
namespace {

constexpr float kRightAngle = 90.0F;
constexpr float kAngleTolerance = 0.001F;  // degrees
constexpr std::int32_t kFirstStack = 401;  // space groups from here on are stacks of volumes

template <class T>
T swapped(T value) {
    auto bytes = bit_cast<std::array<char, sizeof(T)>>(value);
    std::reverse(bytes.begin(), bytes.end());
    return bit_cast<T>(bytes);
}

template <class T>
void swap_all(std::array<T, 3>& values) {
    for (T& value : values) value = swapped(value);
}

// What is read of it.
void swap_numbers(MrcHeader& header) {
    for (auto* triple : {&header.n, &header.start, &header.m, &header.axes}) swap_all(*triple);
    for (auto* triple : {&header.cell, &header.angles, &header.origin}) swap_all(*triple);
    header.mode = swapped(header.mode);
    header.space_group = swapped(header.space_group);
    header.extended_size = swapped(header.extended_size);
}

// Numbers of the wrong byte order are far above any mode and axis.
bool is_plausible(const MrcHeader& header) {
    const auto small = [](std::int32_t v) { return v >= 0 && v < 256; };
    return small(header.mode) && std::all_of(header.axes.begin(), header.axes.end(), small);
}

class MrcReader {
public:
    explicit MrcReader(const std::string& path) : source_(path) {}

    Volume read(VolumePart part) {
        read_header();
        check_header();
        Volume volume{grid(), {}};
        if (part == VolumePart::Grid) return volume;
        check_size(volume.grid);
        skip_extended_header();
        volume.values.resize(volume.grid.size());
        read_values(volume);
        return volume;
    }

private:
    [[noreturn]] void fail(std::size_t offset, const char* field, const std::string& message) const {
        throw InputError(fmt::format("{}:byte {} ({}): {}", source_.path(), offset, field, message));
    }
    [[noreturn]] void fail(const std::string& message) const {
        throw InputError(fmt::format("{}: {}", source_.path(), message));
    }

    void read_header() {
        if (source_.read(reinterpret_cast<char*>(&header_), sizeof header_) < sizeof header_)
            fail("is shorter than the 1024 bytes of an MRC header; it is cut off or not such a map");
        if (std::string_view(header_.map.data(), 3) != "MAP")
            fail(offsetof(MrcHeader, map), "MAP", "'MAP ' is missing; this is not an MRC or CCP4 map");
        if (is_plausible(header_)) return;
        swap_numbers(header_);
        swapped_ = true;
    }

    void check_header() const {
        if (value_size() == 0)
            fail(offsetof(MrcHeader, mode), "MODE",
                 fmt::format("mode {} is not supported; write the map in mode 2 (32-bit numbers)", header_.mode));
        static constexpr std::array kCounts{"NX", "NY", "NZ"};
        static constexpr std::array kIntervals{"MX", "MY", "MZ"};
        static constexpr std::array kEdges{"CELLA x", "CELLA y", "CELLA z"};
        static constexpr std::array kAngles{"CELLB alpha", "CELLB beta", "CELLB gamma"};
        for (std::size_t i = 0; i < 3; ++i) {
            if (header_.n[i] <= 0)
                refuse_triple(offsetof(MrcHeader, n), i, kCounts[i], header_.n[i], "a positive count");
            if (header_.m[i] <= 0)
                refuse_triple(offsetof(MrcHeader, m), i, kIntervals[i], header_.m[i], "a positive count");
            if (!(std::isfinite(header_.cell[i]) && header_.cell[i] > 0.0F))
                refuse_triple(offsetof(MrcHeader, cell), i, kEdges[i], header_.cell[i], "a positive length");
            if (!(std::abs(header_.angles[i] - kRightAngle) <= kAngleTolerance))
                refuse_triple(offsetof(MrcHeader, angles), i, kAngles[i], header_.angles[i],
                              "90 (skew cells are not supported)");
            if (!std::isfinite(header_.origin[i]))
                refuse_triple(offsetof(MrcHeader, origin), i, "ORIGIN", header_.origin[i], "finite");
        }
        std::array<std::int32_t, 3> sorted = header_.axes;
        std::sort(sorted.begin(), sorted.end());
        if (sorted != std::array<std::int32_t, 3>{1, 2, 3})
            fail(offsetof(MrcHeader, axes), "MAPC MAPR MAPS",
                 fmt::format("{} {} {} are not the axes 1, 2 and 3 in some order; correct them", header_.axes[0],
                             header_.axes[1], header_.axes[2]));
        if (header_.space_group >= kFirstStack)
            fail(offsetof(MrcHeader, space_group), "ISPG", "a stack of volumes; write one volume per file");
        if (header_.extended_size < 0)
            fail(offsetof(MrcHeader, extended_size), "NSYMBT",
                 fmt::format("{} is not the size of a header; correct it", header_.extended_size));
    }

    template <class T>
    [[noreturn]] void refuse_triple(std::size_t offset, std::size_t i, const char* field, T value,
                                    const char* wanted) const {
        fail(offset + 4 * i, field, fmt::format("{} must be {}; correct the header", value, wanted));
    }

    std::size_t value_size() const {
        switch (header_.mode) {
            case 0:
                return 1;
            case 1:
            case 6:
                return 2;
            case 2:
                return 4;
            default:
                return 0;
        }
    }

    // Which of columns, rows and sections run along an axis (0, 1, 2).
    std::size_t runner(std::size_t axis) const {
        return static_cast<std::size_t>(
            std::find(header_.axes.begin(), header_.axes.end(), static_cast<std::int32_t>(axis) + 1) -
            header_.axes.begin());
    }

    VolumeGrid grid() const {
        std::array<double, 3> spacing{};
        std::array<double, 3> origin{};
        VolumeGrid grid;
        const bool has_origin =
            std::any_of(header_.origin.begin(), header_.origin.end(), [](float x) { return x != 0.0F; });
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t along = runner(axis);
            grid.counts[axis] = static_cast<std::size_t>(header_.n[along]);
            spacing[axis] = static_cast<double>(header_.cell[axis]) / header_.m[axis];
            origin[axis] =
                has_origin ? static_cast<double>(header_.origin[axis]) : header_.start[along] * spacing[axis];
        }
        grid.origin = {origin[0], origin[1], origin[2]};
        grid.spacing = {spacing[0], spacing[1], spacing[2]};
        return grid;
    }

    // Counts are below 2^31 each: their product may not fit into 64 bits.
    void check_size(const VolumeGrid& grid) const {
        const std::uint64_t before = sizeof header_ + static_cast<std::uint64_t>(header_.extended_size);
        const std::uint64_t room = source_.most() < before ? 0 : (source_.most() - before) / value_size();
        const std::uint64_t plane = grid.counts[0] * grid.counts[1];
        if (grid.counts[2] > room / plane)
            fail(fmt::format("the file is too short for {} x {} x {} values; it is cut off, fetch or write it again",
                             header_.n[0], header_.n[1], header_.n[2]));
    }

    void skip_extended_header() {
        std::vector<char> buffer(std::size_t{1} << 16U);
        for (auto rest = static_cast<std::size_t>(header_.extended_size); rest > 0;) {
            const std::size_t part = source_.read(buffer.data(), std::min(rest, buffer.size()));
            if (part == 0) fail("the file ends in its extended header; it is cut off, fetch or write it again");
            rest -= part;
        }
    }

    void read_values(Volume& volume) {
        const std::array<std::size_t, 3> step_of_axis{volume.grid.counts[1] * volume.grid.counts[2],
                                                      volume.grid.counts[2], 1};
        std::array<std::size_t, 3> steps{};
        for (std::size_t axis = 0; axis < 3; ++axis) steps[runner(axis)] = step_of_axis[axis];
        std::vector<char> row(static_cast<std::size_t>(header_.n[0]) * value_size());
        for (std::size_t section = 0; section < static_cast<std::size_t>(header_.n[2]); ++section)
            for (std::size_t line = 0; line < static_cast<std::size_t>(header_.n[1]); ++line) {
                if (source_.read(row.data(), row.size()) < row.size())
                    fail("the file ends before its last value; it is cut off, fetch or write it again");
                decode(row, &volume.values[section * steps[2] + line * steps[1]], steps[0]);
                offset_ += row.size();
            }
        if (source_.peek() != ByteSource::kEnd) fail("the file is longer than its header says; write it again");
    }

    void decode(const std::vector<char>& row, float* values, std::size_t step) const {
        switch (header_.mode) {
            case 0:
                return decode_as<std::int8_t>(row, values, step);
            case 1:
                return decode_as<std::int16_t>(row, values, step);
            case 6:
                return decode_as<std::uint16_t>(row, values, step);
            default:
                return decode_as<float>(row, values, step);
        }
    }

    template <class T>
    void decode_as(const std::vector<char>& row, float* values, std::size_t step) const {
        for (std::size_t i = 0; i < row.size() / sizeof(T); ++i) {
            T stored{};
            std::memcpy(&stored, row.data() + i * sizeof(T), sizeof(T));
            const auto value = static_cast<float>(swapped_ ? swapped(stored) : stored);
            if (!std::isfinite(value))
                fail(sizeof header_ + static_cast<std::size_t>(header_.extended_size) + offset_ + i * sizeof(T),
                     "value", "is not a finite number; correct it");
            values[i * step] = value;
        }
    }

    ByteSource source_;
    MrcHeader header_;
    bool swapped_ = false;
    std::size_t offset_ = 0;  // of the row, from the first value
};

}  // namespace

Volume read_mrc(const std::string& path, VolumePart part) { return MrcReader(path).read(part); }

}  // namespace meniscus
