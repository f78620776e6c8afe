// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Results as dicts with the keys of the report: a visitor of what meniscus/describe_results.h describes.
#pragma once

#include <pybind11/stl.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "arrays.h"
#include "meniscus/describe_results.h"

namespace meniscus::python {

template <class T>
py::object object_of(const T& value) {
    return py::cast(value);
}
inline py::object object_of(const Vec3& v) { return py::make_tuple(v.x, v.y, v.z); }
inline py::object object_of(const std::vector<std::uint32_t>& indices) {
    return owning(std::vector<std::uint32_t>(indices));
}
template <class T>
py::object object_of(const std::optional<T>& value) {
    return value ? object_of(*value) : py::none();
}

class DictVisitor {
public:
    template <class T>
    void operator()(const Quantity& quantity, const T& value) {
        dict_[quantity.name] = object_of(value);
    }
    template <class T, std::size_t N>
    void operator()(const Quantity& quantity, T value, const Words<T, N>& words) {
        dict_[quantity.name] = word_for(words, value);
    }
    template <class Inside>
    void block(const Quantity& quantity, const Inside& inside) {
        DictVisitor inner;
        inside(inner);
        dict_[quantity.name] = inner.dict_;
    }
    template <class Maybe, class Inside>
    void optional_block(const Quantity& quantity, const Maybe& maybe, const Inside& inside) {
        dict_[quantity.name] = py::none();
        if (maybe) block(quantity, [&](auto& inner) { inside(inner, *maybe); });
    }
    template <class T, class Inside>
    void list(const Quantity& quantity, const std::vector<T>& elements, const Inside& inside) {
        py::list all;
        for (const T& element : elements) {
            DictVisitor inner;
            inside(inner, element);
            all.append(inner.dict_);
        }
        dict_[quantity.name] = all;
    }

    const py::dict& dict() const { return dict_; }

private:
    py::dict dict_;
};

/// What describe(result, visitor) says of a result.
template <class T>
py::dict dict_of(const T& result) {
    DictVisitor visit;
    describe(result, visit);
    return visit.dict();
}

/// The same of each.
template <class T>
py::list dicts_of(const std::vector<T>& results) {
    py::list list;
    for (const T& result : results) list.append(dict_of(result));
    return list;
}

}  // namespace meniscus::python
