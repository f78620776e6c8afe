// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/loaded_library.h"

#ifndef MENISCUS_PORTABLE
#include <dlfcn.h>
#endif

#include <new>
#include <stdexcept>
#include <string>

namespace meniscus {

#ifdef MENISCUS_PORTABLE
// Everything is linked; a static program cannot load anything.
std::optional<LoadedLibrary> LoadedLibrary::load(const char* /*name*/) { return LoadedLibrary(nullptr); }

void* LoadedLibrary::symbol(const char* /*name*/) const { return handle_; }
#else
namespace {

#ifdef __APPLE__
// libembree3.so.3 is libembree3.3.dylib there.
std::string file_name(std::string name) {
    const std::size_t at = name.find(".so.");
    return at == std::string::npos ? name : name.erase(at, 3) + ".dylib";
}
#else
std::string file_name(std::string name) { return name; }
#endif

}  // namespace

// Words are all that the loader has for its reasons.
std::optional<LoadedLibrary> LoadedLibrary::load(const char* name) {
    if (void* const handle = dlopen(file_name(name).c_str(), RTLD_NOW | RTLD_LOCAL); handle != nullptr)
        return LoadedLibrary(handle);
    const std::string reason = dlerror();
    const auto says = [&](const char* words) { return reason.find(words) != std::string::npos; };
    if (says("No such file") || says("no such file")) return std::nullopt;
    if (says("memory") || says("map segment")) throw std::bad_alloc();
    throw std::runtime_error(reason);
}

void* LoadedLibrary::symbol(const char* name) const {
    void* const found = dlsym(handle_, name);
    if (found == nullptr) throw std::runtime_error(dlerror());
    return found;
}
#endif

}  // namespace meniscus
