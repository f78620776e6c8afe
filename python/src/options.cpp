// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "options.h"

#include <limits>

namespace meniscus::python {

namespace {

[[noreturn]] void refuse_type(const char* option, const char* wanted, const py::object& value) {
    throw py::type_error(std::string(option) + ": must be " + wanted + ", not " + std::string(py::repr(value)));
}

/// As the numbers module has it: neither truth values nor arrays of one number.
bool is_real(const py::object& value) {
    return !py::isinstance<py::bool_>(value) && py::isinstance(value, py::module_::import("numbers").attr("Real"));
}

/// Python's and numpy's True and False, and 1 and 0.
bool truth_of(const char* option, const py::object& value) {
    const std::string type = Py_TYPE(value.ptr())->tp_name;
    const bool is_flag = py::isinstance<py::bool_>(value) || type.starts_with("numpy.bool");
    if (is_flag || (py::isinstance<py::int_>(value) && (value.equal(py::int_(0)) || value.equal(py::int_(1)))))
        return value.equal(py::bool_(true));
    refuse_type(option, "True or False", value);
}

}  // namespace

std::string Options::text(const char* name) const {
    const py::object value = given_[name];
    if (!py::isinstance<py::str>(value)) refuse_type(name, "text", value);
    Py_ssize_t size = 0;
    const char* utf8 = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
    if (utf8 == nullptr) throw py::error_already_set();
    return {utf8, static_cast<std::size_t>(size)};
}

double OptionReader::number(const Option& option) const {
    const py::object value = given_[option.name];
    const bool is_text = py::isinstance<py::str>(value);
    if (option.range == NumberRange::PositiveOrInfinite && is_text && given_.text(option.name) == "inf")
        return std::numeric_limits<double>::infinity();
    if (!is_real(value)) refuse_type(option.name, "a number", value);
    const double result = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr) {
        if (PyErr_ExceptionMatches(PyExc_OverflowError) == 0) throw py::error_already_set();
        PyErr_Clear();
        throw UsageError(std::string(option.name) + ": the number is too large");
    }
    if (!contains(option.range, result))
        throw UsageError(std::string(option.name) + ": must be " + words_for(option.range) + ", not " +
                         std::string(py::str(value)));
    return result;
}

void OptionReader::operator()(const Option& option, bool& target) {
    if (given_.has(option.name)) set(option, target, truth_of(option.name, given_[option.name]));
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
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
    const std::string text = py::str(value);
    if (overflow > 0 || whole > std::numeric_limits<int>::max())
        throw UsageError(std::string(option.name) + ": " + text + " is too large");
    if (overflow < 0 || !contains(option.range, static_cast<double>(whole)))
        throw UsageError(
            std::string(option.name) + ": must be " +
            (option.range == NumberRange::Positive ? "a whole number of at least 1" : "0 (all cores) or more") +
            ", not " + text);
    set(option, target, static_cast<int>(whole));
}

void OptionReader::operator()(const Option& option, std::size_t& target) { given_.read(option.name, target); }

void OptionReader::operator()(const Option& option, double& target, double (*of)(double)) {
    if (given_.has(option.name)) set(option, target, of(number(option)));
}

}  // namespace meniscus::python
