// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/model/world.h"
#include "ros_edge/inputs/inputs.h"
#include "ros_edge/parameters/monitor_setup.h"

/// What changes of objects may refer to.
namespace collision_monitor {

/// placesOf now: the frames that tf knows, and the newest poses. Asks tf for the frames that it has
/// not kept so far, and waits up to `patience` [s] for all of them together.
/// @pre the arguments outlive the places
KnownPlaces placesNow(const MonitorSetup& setup, const Inputs& inputs, double patience);

}  // namespace collision_monitor
