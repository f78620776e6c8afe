// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/own_file.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#ifdef __linux__
#include <sys/auxv.h>
#elif defined(__APPLE__)
#include <mach-o/dyld.h>
#endif

namespace meniscus {
namespace {

#ifdef __linux__
// Where the system shows no processes, as in a bare chroot, the name that the program was started by is left.
std::string started_as() {
    std::error_code error;
    const std::filesystem::path link = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error) return link.string();
    // NOLINTNEXTLINE(performance-no-int-to-ptr): this is how the kernel hands the address over
    const auto* const name = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
    return name == nullptr ? "" : name;
}
#elif defined(__APPLE__)
std::string started_as() {
    char name[4096];
    std::uint32_t size = sizeof name;
    return _NSGetExecutablePath(name, &size) == 0 ? name : "";
}
#else
std::string started_as() { return ""; }
#endif

}  // namespace

std::string program_file() {
    const std::string name = started_as();
    std::error_code error;
    const std::filesystem::path path = std::filesystem::absolute(name, error);
    return name.empty() || error ? "" : path.string();
}

std::string file_that_holds(const void* code) {
    Dl_info found{};
    return ::dladdr(code, &found) != 0 && found.dli_fname != nullptr ? found.dli_fname : "";
}

}  // namespace meniscus
