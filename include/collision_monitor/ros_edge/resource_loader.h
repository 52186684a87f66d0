// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/model/urdf_reader.h"

namespace collision_monitor {

/// Reads package://, file:// and http(s):// URIs through resource_retriever, and plain
/// absolute paths. Blanks and letters of any language may stand in paths, packages and
/// file:// URIs; in the latter two %XX is an escape, as in any URI.
/// One connection serves all calls; not for several threads at once.
/// @throws std::exception from the loader, with a sentence: no such package, or what curl says.
ResourceLoader makeResourceLoader();

}  // namespace collision_monitor
