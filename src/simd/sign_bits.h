// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Signs of a few numbers as bits, set where a number is below 0.
#pragma once

#ifdef __SSE2__
#include <immintrin.h>
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace meniscus {

#ifdef __SSE2__
inline std::uint64_t negative_bits(const std::array<float, 4>& values) {
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(_mm_loadu_ps(values.data()), _mm_setzero_ps())));
}
inline std::uint64_t negative_bits(const std::array<std::int32_t, 4>& values) {
    __m128 bits;
    std::memcpy(&bits, values.data(), sizeof(bits));
    return static_cast<unsigned>(_mm_movemask_ps(bits));
}
inline std::uint64_t negative_bits(const std::array<std::int64_t, 2>& values) {
    __m128d bits;
    std::memcpy(&bits, values.data(), sizeof(bits));
    return static_cast<unsigned>(_mm_movemask_pd(bits));
}
#else
template <class T, std::size_t N>
std::uint64_t negative_bits(const std::array<T, N>& values) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < N; ++i) bits |= std::uint64_t{values[i] < T{}} << i;
    return bits;
}
#endif

}  // namespace meniscus
