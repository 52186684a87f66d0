// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/srdf_reader.h"
#include "model/name_index.h"
#include "model/place.h"
#include "model/xml_document.h"

namespace collision_monitor {

/// The `<link_sphere_approximation>` elements below `root`. As in MoveIt, spheres of radius 0 are
/// left out, and a link that has no others has no approximation.
///
/// Warnings: numbers that cannot be read or are out of range; that link then has no approximation.
/// Unknown links are left out without a word: readGroups tells of them.
std::vector<SrdfPairs::Spheres> readSpheres(const tinyxml2::XMLElement& root,
                                            const NameIndex& names, const Place& place);

}  // namespace collision_monitor
