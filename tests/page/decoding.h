// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Reads back what pages hold, for tests.
#pragma once

#include <zlib.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "page/page_data.h"
#include "support/small_molecule.h"

namespace meniscus::testing {

inline std::vector<std::uint64_t> varints(std::string_view bytes) {
    std::vector<std::uint64_t> values;
    for (std::size_t i = 0; i < bytes.size();) {
        std::uint64_t value = 0;
        unsigned shift = 0;
        unsigned char byte = 0;
        do {
            byte = static_cast<unsigned char>(bytes[i++]);
            value |= static_cast<std::uint64_t>(byte & 127U) << shift;
            shift += 7U;
        } while (byte > 127U);
        values.push_back(value);
    }
    return values;
}

inline std::vector<std::int64_t> sums(std::string_view bytes) {
    std::vector<std::int64_t> values;
    std::int64_t sum = 0;
    for (const std::uint64_t code : varints(bytes)) {
        sum += static_cast<std::int64_t>(code >> 1U) ^ -static_cast<std::int64_t>(code & 1U);
        values.push_back(sum);
    }
    return values;
}

/// Corners of triangles from the codes of VertexOrder.
inline std::vector<Triangle> triangles(std::string_view bytes) {
    std::vector<Triangle> list;
    VertexId next = 0;
    std::size_t corner = 0;
    for (const std::uint64_t code : varints(bytes)) {
        if (corner % 3 == 0) list.emplace_back();
        list.back()[corner++ % 3] = next - static_cast<VertexId>(code);
        if (code == 0) ++next;
    }
    return list;
}

inline std::string inflated(const std::string& packed) {
    std::string bytes(1U << 24U, '\0');
    uLongf size = bytes.size();
    if (uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                   packed.size()) != Z_OK)
        return "";
    bytes.resize(size);
    return bytes;
}

/// page_data() taken apart.
struct DecodedPage {
    explicit DecodedPage(const std::string& data) : bytes(data) {
        std::size_t length = 0;
        for (unsigned i = 0; i < 4; ++i) length |= std::size_t{static_cast<unsigned char>(bytes[i])} << 8U * i;
        info = nlohmann::json::parse(bytes.substr(4, length));
        begin = 4 + length;
    }
    std::string_view stream(const std::string& name) const {
        const auto& place = info.at("streams").at(name);
        return std::string_view(bytes).substr(begin + place[0].get<std::size_t>(), place[1].get<std::size_t>());
    }

    std::string bytes;
    nlohmann::json info;
    std::size_t begin = 0;
};

}  // namespace meniscus::testing
