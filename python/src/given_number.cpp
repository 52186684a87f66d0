// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "given_number.h"

#include "collision_monitor/arguments.h"

namespace collision_monitor::python {
namespace {

namespace py = pybind11;

/// A short value as Python writes it; of others, the type.
std::string valueText(const py::object& given) {
  constexpr std::size_t kLongest = 40;
  if (given.is_none() || py::isinstance<py::str>(given) || py::isinstance<py::int_>(given) ||
      py::isinstance<py::float_>(given)) {
    try {
      const auto shown = py::cast<std::string>(py::repr(given));
      if (shown.size() <= kLongest) {
        return shown;
      }
    } catch (const py::error_already_set&) {  // such as an int of too many digits
    } catch (const py::cast_error&) {
    }
  }
  return "of type '" + std::string(Py_TYPE(given.ptr())->tp_name) + "'";
}

[[noreturn]] void refuse(const char* name, const py::object& given, const std::string& accepted) {
  PyErr_Clear();
  throw ArgumentError(
      {"`" + std::string(name) + "` is " + valueText(given) + "; accepted: " + accepted});
}

}  // namespace

double numberOf(const GivenNumber& number, const char* name) {
  const double value = PyFloat_AsDouble(number.value.ptr());
  if (PyErr_Occurred() != nullptr) {
    refuse(name, number.value, "a number");
  }
  return value;
}

std::uint64_t countOf(const GivenCount& count, const char* name, std::uint64_t most) {
  const std::string accepted = "a whole number from 0 to " + std::to_string(most);
  const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(count.value.ptr()));
  if (!whole) {
    refuse(name, count.value, accepted);
  }
  const std::uint64_t value = PyLong_AsUnsignedLongLong(whole.ptr());
  if (PyErr_Occurred() != nullptr || value > most) {
    refuse(name, count.value, accepted);
  }
  return value;
}

}  // namespace collision_monitor::python
