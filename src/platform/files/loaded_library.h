// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Libraries that are loaded when they are first needed, not with the program, and for good; or, in a portable build
// (MENISCUS_PORTABLE), are linked into the program, which then needs no other file.
#pragma once

#include <optional>

namespace meniscus {

class LoadedLibrary {
public:
    /// name     of a file, or one for the loader to look for
    /// returns  nothing where it, or a library that it needs, is not there
    /// throws   std::bad_alloc without the memory for it; std::runtime_error with the loader's words for any other
    /// reason
    static std::optional<LoadedLibrary> load(const char* name);

    /// throws   std::runtime_error where the library has no such function
    template <class Function>
    void find(const char* name, Function*& function) const {
        function = reinterpret_cast<Function*>(symbol(name));
    }

private:
    explicit LoadedLibrary(void* handle) : handle_(handle) {}
    void* symbol(const char* name) const;

    void* handle_;
};

}  // namespace meniscus

/// Sets a pointer to a function of a library that was loaded; in a portable build, to the one that is linked.
#ifdef MENISCUS_PORTABLE
#define MENISCUS_FIND(library, name, function) (function) = &(name)
#else
#define MENISCUS_FIND(library, name, function) (library)->find(#name, function)
#endif
