// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "io/png.h"
#include "meniscus/write.h"
#include "platform/files/atomic_file.h"

namespace meniscus {

void write_picture(const std::string& path, const Picture& picture) {
    const std::string content = encode_png(picture);
    AtomicFile file(path);
    file.write(content);
    file.commit();
}

}  // namespace meniscus
