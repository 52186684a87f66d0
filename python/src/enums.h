// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include "collision_monitor/narrow_phase/quality.h"
#include "collision_monitor/pipeline/trajectory_options.h"
#include "collision_monitor/pipeline/verdict.h"

/// Members of the enums in collision_monitor_core.enums, and their names. The numbers are the same.
namespace collision_monitor::python {

/// Looks the members up, once, when the module is made.
void findMembers();

pybind11::object member(Verdict verdict);
pybind11::object member(Quality quality);
pybind11::object member(ApproachState state);

const char* nameOf(Verdict verdict) noexcept;
const char* nameOf(Quality quality) noexcept;
const char* nameOf(ApproachState state) noexcept;

}  // namespace collision_monitor::python
