// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ros_edge/parameters/parameters.h"
#include "ros_edge/parameters/robot_descriptions.h"

namespace collision_monitor {

/// What a start reads.
struct StartInput {
  const Parameters& parameters;
  const LoadedRobots& robots;  ///< without a description: which links there are is not known
  const ResourceLoader& load_resource;
  bool is_reload;  ///< objects are not read again
};

/// Adds the faults that a start has not reached when it ends with the first of them, so that the
/// user sees all at once. Reads descriptions, objects and rules anew, and fits nothing.
/// @param report the faults that are told already
void addOtherFaults(const StartInput& input, SetupReport& report);

}  // namespace collision_monitor
