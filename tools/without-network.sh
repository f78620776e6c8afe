#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Runs a command that sees no network but its own machine: tools/without-network.sh COMMAND ...
# Root is not needed where users may make namespaces of their own.
set -euo pipefail
as_root=()
if [ "$(id -u)" -ne 0 ]; then as_root=(--user --map-root-user); fi
# Browsers and their drivers talk to each other over the loopback device, which is down in a new namespace; Slurm needs a
# second address of it, since it takes a machine with 127.0.0.1 alone for one that no name leads to.
raise_loopback='import fcntl, os, socket, struct, sys
SIOCSIFFLAGS, SIOCSIFADDR, IFF_UP, IFF_LOOPBACK = 0x8914, 0x8916, 1, 8
with socket.socket() as any_socket:
    fcntl.ioctl(any_socket, SIOCSIFFLAGS, struct.pack("16sH14x", b"lo", IFF_UP | IFF_LOOPBACK))
    second = struct.pack("16sHH4s16x", b"lo:1", socket.AF_INET, 0, socket.inet_aton("127.0.0.2"))
    fcntl.ioctl(any_socket, SIOCSIFADDR, second)
os.execvp(sys.argv[1], sys.argv[1:])'
exec unshare "${as_root[@]}" --net python3 -c "$raise_loopback" "$@"
