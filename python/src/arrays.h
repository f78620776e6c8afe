// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The library's arrays as numpy arrays, and back, without copies where memory can be shared.
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "meniscus/colour.h"
#include "meniscus/errors.h"
#include "meniscus/mesh.h"
#include "meniscus/vec3.h"

namespace meniscus::python {

namespace py = pybind11;

/// How an element looks to numpy: so many numbers of a type in a row.
template <class T>
struct ElementOf {
    using Number = T;
    static constexpr py::ssize_t kColumns = 1;
};
template <>
struct ElementOf<Vec3> {
    using Number = double;
    static constexpr py::ssize_t kColumns = 3;
};
/// Indices are signed for users: torch knows no others. None is as large as 2^31 (refuse_large_indices()).
template <>
struct ElementOf<std::uint32_t> {
    using Number = std::int32_t;
    static constexpr py::ssize_t kColumns = 1;
};
template <>
struct ElementOf<Triangle> {
    using Number = std::int32_t;
    static constexpr py::ssize_t kColumns = 3;
};
template <>
struct ElementOf<PatchKind> {
    using Number = std::uint8_t;
    static constexpr py::ssize_t kColumns = 1;
};

template <>
struct ElementOf<Colour> {
    using Number = std::uint8_t;
    static constexpr py::ssize_t kColumns = 4;
};

/// throws   LimitError for a mesh whose indices do not all fit into the arrays that users see
inline void refuse_large_indices(const Mesh& mesh) {
    if (mesh.vertices.size() > std::size_t{std::numeric_limits<std::int32_t>::max()})
        throw LimitError("a mesh of more than 2^31 - 1 vertices has no index arrays in Python; use a coarser spacing");
}

/// Memory of `owner` as an array of shape (n,) or (n, columns) that cannot be written to and keeps the owner alive.
template <class T>
py::array view(std::span<const T> values, const py::handle& owner) {
    using Number = typename ElementOf<T>::Number;
    constexpr py::ssize_t kColumns = ElementOf<T>::kColumns;
    static_assert(sizeof(T) == kColumns * sizeof(Number));
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(values.size())};
    if (kColumns > 1) shape.push_back(kColumns);
    py::array array(py::dtype::of<Number>(), std::move(shape), {}, values.data(), owner);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

/// An array that takes over the memory of `values`.
template <class T>
py::array owning(std::vector<T>&& values) {
    auto* held = new std::vector<T>(std::move(values));
    const py::capsule owner(held, [](void* p) { delete static_cast<std::vector<T>*>(p); });
    const std::span<const T> all(*held);
    return view(all, owner);
}

/// The same for results of functions, which nobody else holds: it may be written to.
template <class T>
py::array given_away(std::vector<T>&& values) {
    py::array array = owning(std::move(values));
    py::detail::array_proxy(array.ptr())->flags |= py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

/// A member of every row.
template <class Row, class T>
py::array column_of(const std::vector<Row>& rows, T Row::*member) {
    std::vector<T> values;
    values.reserve(rows.size());
    for (const Row& row : rows) values.push_back(row.*member);
    return owning(std::move(values));
}

/// What meniscus/_arrays.py makes of any array of positions: (n, 3), contiguous, finite.
using Positions = py::array_t<double, py::array::c_style>;
using Numbers = py::array_t<double, py::array::c_style>;

inline std::span<const Vec3> points_of(const Positions& positions) {
    if (positions.ndim() != 2 || positions.shape(1) != 3) throw py::value_error("an array of shape (n, 3) is needed");
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return {reinterpret_cast<const Vec3*>(positions.data()), static_cast<std::size_t>(positions.shape(0))};
}

inline std::span<const double> numbers_of(const Numbers& numbers) {
    if (numbers.ndim() != 1) throw py::value_error("an array of shape (n,) is needed");
    return {numbers.data(), static_cast<std::size_t>(numbers.shape(0))};
}

}  // namespace meniscus::python
