#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Runs a command that sees no network but its own machine: tools/without-network.sh COMMAND ...
# Root is not needed where users may make namespaces of their own.
set -euo pipefail
as_root=()
if [ "$(id -u)" -ne 0 ]; then as_root=(--user --map-root-user); fi
# Browsers and their drivers talk to each other over the loopback device, which is down in a new namespace.
raise_loopback='import fcntl, os, socket, struct, sys
SIOCSIFFLAGS, IFF_UP, IFF_LOOPBACK = 0x8914, 1, 8
with socket.socket() as any_socket:
    fcntl.ioctl(any_socket, SIOCSIFFLAGS, struct.pack("16sH14x", b"lo", IFF_UP | IFF_LOOPBACK))
os.execvp(sys.argv[1], sys.argv[1:])'
exec unshare "${as_root[@]}" --net python3 -c "$raise_loopback" "$@"
