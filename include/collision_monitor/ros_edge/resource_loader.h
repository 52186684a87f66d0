// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/model/urdf_reader.h"

namespace collision_monitor {

/// Reads package://, file:// and http(s):// URIs through resource_retriever, and plain
/// absolute paths. One connection serves all calls; not for several threads at once.
ResourceLoader makeResourceLoader();

}  // namespace collision_monitor
