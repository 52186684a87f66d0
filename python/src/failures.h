// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace collision_monitor::python {

/// Text for Python. Bytes that are no UTF-8 become question marks in a box.
pybind11::str text(const std::string& bytes);

/// A class of collision_monitor_core.records or .errors.
pybind11::object pythonClass(const char* module, const char* name);

/// Lets SetupError and ArgumentError reach Python as classes of the same names, with their lists.
void translateFailures();

}  // namespace collision_monitor::python
