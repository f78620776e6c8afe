// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <limits>
#include <new>

#include "meniscus/errors.h"
#include "meniscus/version.h"
#include "objects.h"

namespace meniscus::c {
namespace {

thread_local std::string last_error;

}  // namespace

meniscus_status failed(meniscus_status status, const char* message) {
    try {
        last_error = message;
        // Names of files and of options may hold anything; a message is one line.
        for (char& c : last_error)
            if (static_cast<unsigned char>(c) < ' ') c = '?';
    } catch (const std::bad_alloc&) {
        last_error.clear();
    }
    return status;
}

meniscus_status status_of_exception() {
    try {
        throw;
    } catch (const Stopped&) {
        return failed(MENISCUS_STOPPED, "stopped by the caller");
    } catch (const InputError& error) {
        return failed(MENISCUS_INPUT, error.what());
    } catch (const OutputError& error) {
        return failed(MENISCUS_OUTPUT, error.what());
    } catch (const LimitError& error) {
        return failed(MENISCUS_LIMIT, error.what());
    } catch (const std::bad_alloc&) {
        return failed(MENISCUS_LIMIT, "not enough memory; use a larger spacing or fewer atoms");
    } catch (const std::length_error&) {
        return failed(MENISCUS_LIMIT, "not enough memory; use a larger spacing or fewer atoms");
    } catch (const std::invalid_argument& error) {  // UsageError, and what the geometry says of atoms
        return failed(MENISCUS_USAGE, error.what());
    } catch (const std::exception& error) {
        return failed(MENISCUS_FAILED, error.what());
    } catch (...) {
        return failed(MENISCUS_FAILED, "an unknown exception");
    }
}

void need(const void* argument, const char* name) {
    if (argument == nullptr) throw UsageError(std::string(name) + ": must not be NULL");
}

void need_room(std::size_t items, const char* name) {
    constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
    if (items > kMost) throw LimitError(std::string(name) + ": at most " + std::to_string(kMost) + " are possible");
}

}  // namespace meniscus::c

const char* meniscus_version(void) { return meniscus::kVersion; }

const char* meniscus_last_error(void) { return meniscus::c::last_error.c_str(); }
