// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <vector>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/robot_monitor.h"

/// Numbers that callers give, in any form that numpy takes as an array of numbers. Masked entries
/// are NaN: they are missing.
namespace collision_monitor::python {

/// Rows of doubles; no copy of an array that has them already.
using Array = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// @param name of the argument, for messages
/// @param accepted what it may be, for messages
/// @throws ArgumentError if it is no array of numbers
Array readArray(const pybind11::object& given, const std::string& name,
                const std::string& accepted);

/// The shape of an array, as Python writes it.
std::string shapeText(const pybind11::array& array);

/// "1 pair", "2 pairs"
std::string countText(std::size_t count, const char* one);

/// One state: n numbers in a row, or a dict of joint names; joints that it leaves out are as in
/// the default state. Always a copy: the caller's array may change while the GIL is free.
/// @throws ArgumentError with all faults
std::vector<double> readState(const RobotMonitor& monitor, const pybind11::object& given);

/// States in rows: m x n. @throws ArgumentError
Array readRows(const RobotMonitor& monitor, const pybind11::object& given, const char* name);

/// A pose: None is the identity; three numbers are a translation; else a 4 x 4 matrix.
/// @throws ArgumentError
Pose readPose(const pybind11::object& given, const std::string& name);

}  // namespace collision_monitor::python
