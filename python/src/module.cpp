// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "enums.h"
#include "failures.h"
#include "robot.h"

namespace {

namespace py = pybind11;

PyObject* refuseNew(PyTypeObject* type, PyObject* /*arguments*/, PyObject* /*named*/) {
  PyErr_Format(PyExc_TypeError, "%s has no constructor: load() and queries make it", type->tp_name);
  return nullptr;
}

/// pybind11 takes what __new__ gives as made, although nothing is in it.
void refuseEmptyInstances(const py::module_& module) {
  for (const auto& [name, member] : module.attr("__dict__").cast<py::dict>()) {
    if (PyType_Check(member.ptr()) &&
        py::detail::get_type_info(reinterpret_cast<PyTypeObject*>(member.ptr())) != nullptr) {
      reinterpret_cast<PyTypeObject*>(member.ptr())->tp_new = refuseNew;
    }
  }
}

}  // namespace

// The extension behind the package collision_monitor_core. Users import the package.
PYBIND11_MODULE(_core, module) {
  namespace binding = collision_monitor::python;
  binding::translateFailures();
  binding::findMembers();
  // Answers come before the calls that return them: signatures then show their Python names.
  binding::bindDistances(module);
  binding::bindMany(module);
  binding::bindRobot(module);
  binding::bindLoading(module);
  binding::bindSolids(module);
  refuseEmptyInstances(module);
}
