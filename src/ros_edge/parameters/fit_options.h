// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ros_edge/parameters/parameters.h"

namespace collision_monitor {

/// The options from the parameters, with the rules file read again. If it cannot be read, an error
/// is added to `report`.
SetupOptions loadSetupOptions(const Parameters& parameters, const ResourceLoader& load_resource,
                              SetupReport& report);

}  // namespace collision_monitor
