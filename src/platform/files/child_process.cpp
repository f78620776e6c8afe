// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/child_process.h"

#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#endif

namespace meniscus {

#ifdef __linux__
bool end_with_parent() { return prctl(PR_SET_PDEATHSIG, SIGKILL) == 0; }

int process_handle(int number) { return static_cast<int>(syscall(SYS_pidfd_open, number, 0)); }
#else
bool end_with_parent() { return true; }

int process_handle(int /*number*/) { return -1; }
#endif

}  // namespace meniscus
