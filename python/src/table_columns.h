// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Tables as Python sees them.
#pragma once

#include <pybind11/pybind11.h>

#include <type_traits>
#include <variant>
#include <vector>

#include "meniscus/tables.h"

namespace meniscus::python {

namespace py = pybind11;

inline py::object cell_object(const Cell& cell) {
    return std::visit(
        [](const auto& value) -> py::object {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
                return py::none();
            else
                return py::cast(value);
        },
        cell);
}

/// A list per column.
inline py::dict table_columns(const Table& table) {
    py::dict columns;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        py::list values;
        for (const std::vector<Cell>& row : table.rows) values.append(cell_object(row[c]));
        columns[py::str(table.columns[c])] = values;
    }
    return columns;
}

}  // namespace meniscus::python
