// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "geometry/sphere_tree.h"

namespace collision_monitor {

/// The spheres of one link, for other programs.
struct LinkSpheres {
  std::string link;
  std::vector<SphereTree> trees;  ///< one per geometry, in the link frame; see placed()
};

/// Text for other programs. Numbers have a decimal point and 9 significant digits in every locale.
/// Each radius grows by the rounding of its center and is then rounded up, so a sphere that is read
/// again holds the sphere of the tree.
///
/// Frames: that of the link. Units: metres.
/// Limits: a smaller radius is written as 1e-12 m, because readers drop spheres without radius.
/// Links without spheres are left out: an empty entry would mean "no collision geometry".
/// @throws std::invalid_argument that names the link, if a sphere is not finite, or a name is empty
/// or holds control characters.

/// Every level, coarse to fine, each complete by itself:
///
///     links:
///       - link: "forearm"
///         levels:
///           - level: 0
///             spheres:
///               - {center: [0.0, 0.0, 0.1], radius: 0.2}
std::string toYaml(const std::vector<LinkSpheres>& links);

/// One `<link_sphere_approximation>` per link, for the `<robot>` element of an SRDF: the spheres of
/// one level, and the leaves above it.
/// Source: the format that srdfdom's Model::initXml reads (MoveIt).
std::string toSrdf(const std::vector<LinkSpheres>& links, std::uint32_t level);

}  // namespace collision_monitor
