// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "failures.h"

#include <exception>

#include "collision_monitor/arguments.h"
#include "collision_monitor/model/problems.h"

namespace collision_monitor::python {
namespace {

namespace py = pybind11;

void raise(const char* name, const py::list& faults) {
  const py::object type = pythonClass("errors", name);
  const py::object failure = type(faults);
  PyErr_SetObject(type.ptr(), failure.ptr());
}

py::tuple asTuple(const Problem& problem) {
  return py::make_tuple(text(problem.where), text(problem.found), text(problem.accepted),
                        text(problem.advice));
}

void translate(std::exception_ptr failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const SetupError& fault) {
    py::list problems;
    for (const Problem& problem : fault.problems()) {
      problems.append(asTuple(problem));
    }
    raise("SetupError", problems);
  } catch (const ArgumentError& fault) {
    py::list faults;
    for (const std::string& sentence : fault.faults()) {
      faults.append(text(sentence));
    }
    raise("ArgumentError", faults);
  }
}

}  // namespace

py::str text(const std::string& bytes) {
  PyObject* decoded =
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "replace");
  if (decoded == nullptr) {
    throw py::error_already_set();
  }
  return py::reinterpret_steal<py::str>(decoded);
}

py::object pythonClass(const char* module, const char* name) {
  return py::module_::import((std::string("collision_monitor_core.") + module).c_str()).attr(name);
}

void translateFailures() { py::register_exception_translator(translate); }

}  // namespace collision_monitor::python
