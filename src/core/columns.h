// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers of many items, one array for each, which vectors can read and write: up to the next multiple of a step, where
// there need not be anything of sense.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "meniscus/vec3.h"

namespace meniscus {

/// Numbers of many items side by side, `kCount` of each. Columns are readable up to the next multiple of kStep.
template <std::size_t kCount, class Number = double, std::size_t kStepOfItems = 64 / sizeof(Number)>
class Columns {
public:
    static constexpr std::size_t kStep = kStepOfItems;

    /// What is added is without sense until it is written.
    void resize(std::size_t items) {
        size_ = items;
        if (columns_[0].size() >= padded_size()) return;
        for (std::vector<Number>& column : columns_) column.resize(padded_size());
    }
    std::size_t size() const { return size_; }
    std::size_t padded_size() const { return (size_ + kStep - 1) / kStep * kStep; }
    Number* operator[](std::size_t column) { return columns_[column].data(); }
    const Number* operator[](std::size_t column) const { return columns_[column].data(); }

private:
    std::size_t size_ = 0;
    std::array<std::vector<Number>, kCount> columns_;
};

/// The first three numbers of an item.
template <std::size_t kCount, std::size_t kStep>
SmallVec3 position_in(const Columns<kCount, float, kStep>& columns, std::size_t item) {
    return {columns[0][item], columns[1][item], columns[2][item]};
}
/// columns: Columns, or pointers to where they begin.
template <class FloatColumns>
void set_position(FloatColumns& columns, std::size_t item, const SmallVec3& p) {
    columns[0][item] = p.x;
    columns[1][item] = p.y;
    columns[2][item] = p.z;
}

}  // namespace meniscus
