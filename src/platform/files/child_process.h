// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What only some systems can do for programs that are started from here.
#pragma once

namespace meniscus {

/// Called in the new process: it ends when the one that started it does. May be called between fork and exec.
///
/// returns  false if the system refuses; true also where no system can do it
bool end_with_parent();

/// A descriptor that can be read once the process with this number has ended; -1 where the system has none (Linux
/// before 5.3, other systems).
int process_handle(int number);

}  // namespace meniscus
