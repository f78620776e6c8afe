// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/guarded.h"

#include <algorithm>
#include <iostream>
#include <new>

#include "heap.h"
#include "interrupt.h"
#include "meniscus/errors.h"
#include "messages.h"

namespace meniscus::dropins {
namespace {

int fail(const std::string& name, int code, const std::string& what) {
    std::cout.flush();
    std::cerr << name << ": error: " << cli::one_line(what) << '\n';
    return code;
}

}  // namespace

int run_guarded(const std::string& name, int argc, char** argv,
                const std::function<void(const std::vector<std::string>&)>& body) {
    cli::prepare_heap();
    cli::hold_standard_streams();
    cli::install_signal_handlers();
    cli::install_last_resort(name.c_str());
    try {
        body(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
        return 0;
    } catch (const UsageError& error) {
        return fail(name, 2, error.what());
    } catch (const InputError& error) {
        return fail(name, 3, error.what());
    } catch (const OutputError& error) {
        return fail(name, 4, error.what());
    } catch (const ChecksFailed& error) {
        return fail(name, 6, error.what());
    } catch (const std::length_error& error) {
        return fail(name, 5, error.what());
    } catch (const std::bad_alloc&) {
        return fail(name, 5, "out of memory");
    } catch (const std::exception& error) {
        if (cli::is_out_of_threads(error)) return fail(name, 5, "no memory to start another thread");
        return fail(name, 1, error.what());
    }
}

void require_passed(const Surface& surface) {
    if (surface.passed()) return;
    std::string failed;
    for (const Check& check : surface.checks)
        if (!check.passed) failed.append(failed.empty() ? "" : ", ").append(check.name);
    throw ChecksFailed("the surface failed its own checks: " + failed + "; outputs are written nevertheless");
}

void warn(const std::string& name, const std::string& text) {
    std::cerr << name << ": warning: " << cli::one_line(text) << '\n';
}

void print(const std::string& text) {
    std::cout << text << std::flush;
    if (!std::cout) throw OutputError("standard output: cannot be written");
}

}  // namespace meniscus::dropins
