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
  std::vector<SphereTree> trees;  ///< one a geometry, each in the link frame; see placed()
};

/// Text that other programs read. Numbers have a decimal point and 9 significant digits in every
/// locale. Each radius is grown by what its center lost to rounding and then rounded up, so that a
/// sphere as it is read again holds the sphere of the tree.
///
/// Frames: that of the link. Units: metres.
/// Limits: a radius below 1e-12 m is written as that, because readers drop spheres without radius.
/// Links without spheres are left out, for an empty entry would mean "no collision geometry".
/// @throws std::invalid_argument that names the link: a sphere that is not finite, or a name that
/// is empty or holds control characters.

/// Every level, coarse to fine, each complete by itself:
///
///     links:
///       - link: "forearm"
///         levels:
///           - level: 0
///             spheres:
///               - {center: [0.0, 0.0, 0.1], radius: 0.2}
std::string toYaml(const std::vector<LinkSpheres>& links);

/// One `<link_sphere_approximation>` a link, to be put into the `<robot>` element of an SRDF: the
/// spheres of one level, and the leaves above it.
/// Source: the format is the one that srdfdom's Model::initXml reads (MoveIt).
std::string toSrdf(const std::vector<LinkSpheres>& links, std::uint32_t level);

}  // namespace collision_monitor
