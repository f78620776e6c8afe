// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Three-dimensional vectors in double precision, the one point type of the library, and a smaller type for directions.
#pragma once

#include <cmath>

namespace meniscus {

/// A point (coordinates in Å) or a direction.
struct Vec3 {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;

    constexpr bool operator==(const Vec3&) const = default;
    constexpr Vec3& operator+=(const Vec3& b) {
        x += b.x;
        y += b.y;
        z += b.z;
        return *this;
    }
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double squared_norm(const Vec3& a) { return dot(a, a); }
inline double norm(const Vec3& a) { return std::sqrt(squared_norm(a)); }

/// a / |a|; precondition: a is not zero.
inline Vec3 normalised(const Vec3& a) { return (1.0 / norm(a)) * a; }

/// A direction in single precision, for arrays that hold one per vertex.
struct SmallVec3 {
    float x = 0.0F;
    float y = 0.0F;
    float z = 0.0F;

    constexpr bool operator==(const SmallVec3&) const = default;
    constexpr operator Vec3() const { return {x, y, z}; }  // NOLINT(google-explicit-constructor): no digit is lost
};

constexpr SmallVec3 operator-(const SmallVec3& a) { return {-a.x, -a.y, -a.z}; }

/// The vector rounded to single precision.
constexpr SmallVec3 to_small(const Vec3& a) {
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

inline bool is_finite(const Vec3& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

}  // namespace meniscus
