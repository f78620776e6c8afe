#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Called by conda-build (meta.yaml), in the folder of the sources: the Python package with the program.
set -euo pipefail
# shellcheck disable=SC2154 # conda-build sets SRC_DIR, PREFIX, PYTHON, CMAKE_ARGS
cd "$SRC_DIR/meniscus"
# shellcheck disable=SC2086 # words
cmake -S . -B build/conda -G Ninja -DCMAKE_BUILD_TYPE=Release ${CMAKE_ARGS-} -DCMAKE_PREFIX_PATH="$PREFIX" \
    -DMENISCUS_PYTHON=ON -DPython_EXECUTABLE="$PYTHON" -DPYTHON_EXECUTABLE="$PYTHON" \
    -DMENISCUS_TESTS=OFF -DMENISCUS_INSTALL=OFF -DMENISCUS_VDB=OFF \
    -DMENISCUS_THREE_JS="$SRC_DIR/three/build/three.min.js" -DMENISCUS_FONT="$SRC_DIR/dejavu/ttf/DejaVuSans.ttf"
cmake --build build/conda --target meniscus_python meniscus_cli
MENISCUS_BUILD=build/conda "$PYTHON" -m pip install --no-deps --no-build-isolation -vv .
