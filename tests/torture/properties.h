// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Runs a property on many arrangements: the same ones every time, and more of them on request.
#pragma once

#include <rapidcheck.h>

#include <functional>

#include "torture/arrangement_generators.h"

namespace meniscus::testing {

/// Holds a property against torture_count(count) values of a generator; one that breaks it (by RC_ASSERT, RC_FAIL or a
/// throw) is shrunk and fails the running test. The seed is fixed unless RC_PARAMS names another.
void expect_property(int count, const rc::detail::Property& property);

template <class T>
void for_all(int count, const rc::Gen<T>& values, const std::function<void(const T&)>& property) {
    expect_property(count, rc::detail::toProperty([&] { property(*values); }));
}

}  // namespace meniscus::testing
