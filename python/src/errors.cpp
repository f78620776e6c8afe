// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/errors.h"

#include <stdexcept>
#include <string_view>

#include "bindings.h"

namespace meniscus::python {

namespace py = pybind11;

namespace {

void raise(const char* name, const char* message) {
    const py::object type = py::module_::import("meniscus._errors").attr(name);
    // Paths need not be text.
    const auto size = static_cast<Py_ssize_t>(std::string_view(message).size());
    const auto text = py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(message, size, "surrogateescape"));
    if (text) PyErr_SetObject(type.ptr(), text.ptr());
}

}  // namespace

/// Everything else has a class of Python's own, as std::bad_alloc MemoryError.
void bind_errors(py::module_& /*module*/) {
    // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 takes a function of this type
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const std::invalid_argument& error) {  // UsageError, and arrays that make no sense
            raise("UsageError", error.what());
        } catch (const InputError& error) {
            raise("InputError", error.what());
        } catch (const OutputError& error) {
            raise("OutputError", error.what());
        } catch (const LimitError& error) {
            raise("LimitError", error.what());
        } catch (const std::runtime_error& error) {
            if (std::string_view(error.what()).find("pthread_create") == std::string_view::npos) throw;
            PyErr_SetString(PyExc_MemoryError, "no memory to start another thread; use fewer threads");
        }
    });
}

}  // namespace meniscus::python
