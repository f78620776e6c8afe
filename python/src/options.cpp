// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "options.h"

#include <limits>

namespace meniscus::python {

namespace {

[[noreturn]] void refuse_type(const char* option, const char* wanted, const py::object& value) {
    throw py::type_error(std::string(option) + ": must be " + wanted + ", not " + std::string(py::repr(value)));
}

}  // namespace

std::string Options::text(const char* name) const {
    const py::object value = given_[name];
    if (!py::isinstance<py::str>(value)) refuse_type(name, "text", value);
    return value.cast<std::string>();
}

double OptionReader::number(const Option& option) const {
    const py::object value = given_[option.name];
    if (option.range == NumberRange::PositiveOrInfinite && py::isinstance<py::str>(value) &&
        given_.text(option.name) == "inf")
        return std::numeric_limits<double>::infinity();
    const bool is_text_or_flag = py::isinstance<py::str>(value) || py::isinstance<py::bool_>(value);
    const double result = is_text_or_flag ? 0.0 : PyFloat_AsDouble(value.ptr());
    if (is_text_or_flag || PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        refuse_type(option.name, "a number", value);
    }
    if (!contains(option.range, result))
        throw UsageError(std::string(option.name) + ": must be " + words_for(option.range) + ", not " +
                         std::string(py::str(value)));
    return result;
}

void OptionReader::operator()(const Option& option, bool& target) {
    if (given_.has(option.name)) set(option, target, PyObject_IsTrue(given_[option.name].ptr()) == 1);
}

void OptionReader::operator()(const Option& option, double& target) {
    if (given_.has(option.name)) set(option, target, number(option));
}

void OptionReader::operator()(const Option& option, int& target) {
    if (!given_.has(option.name)) return;
    const py::object value = given_[option.name];
    if (py::isinstance<py::bool_>(value) || PyIndex_Check(value.ptr()) == 0)
        refuse_type(option.name, "a whole number", value);
    int overflow = 0;
    const long long whole = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
    if (overflow != 0 || whole > std::numeric_limits<int>::max() || !contains(option.range, static_cast<double>(whole)))
        throw UsageError(
            std::string(option.name) + ": must be " +
            (option.range == NumberRange::Positive ? "a whole number of at least 1" : "0 (all cores) or more") +
            ", not " + std::string(py::str(value)));
    set(option, target, static_cast<int>(whole));
}

void OptionReader::operator()(const Option& option, std::size_t& target) { given_.read(option.name, target); }

void OptionReader::operator()(const Option& option, double& target, double (*of)(double)) {
    if (given_.has(option.name)) set(option, target, of(number(option)));
}

}  // namespace meniscus::python
