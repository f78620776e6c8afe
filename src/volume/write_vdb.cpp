// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/errors.h"
#include "volume/writers.h"

namespace meniscus {

bool vdb_supported() { return false; }

void write_vdb(const std::string& path, const Volume&, VolumeContent) {
    throw UsageError(path +
                     ": this build writes no .vdb; install libopenvdb-dev and build again, or ask for .dx or .mrc");
}

}  // namespace meniscus
