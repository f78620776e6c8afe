#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Runs a command that sees no network but its own machine: tools/without-network.sh COMMAND ...
# Root is not needed where users may make namespaces of their own.
set -euo pipefail
as_root=()
if [ "$(id -u)" -ne 0 ]; then as_root=(--user --map-root-user); fi
# Browsers and their drivers talk to each other over the loopback device, which is down in a new namespace.
exec unshare "${as_root[@]}" --net bash -c 'ip link set lo up && exec "$@"' bash "$@"
