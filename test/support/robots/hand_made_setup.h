// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor::test {

/// A shape on a link. Links are numbered from 0 and called "link_0", ...
struct ShapeOnLink {
  std::size_t link;
  Shape shape;
  Pose link_from_body{};
};

/// A set-up of free-floating links with exact shapes. Every pair of links is checked.
/// @pre shapes are in order of link.
CycleSetup handMadeSetup(const std::vector<ShapeOnLink>& shapes, const Limits& limits = Limits());

/// All links known at the origin.
LinkPoses knownPoses(const CycleSetup& setup);

/// About z.
inline const Eigen::Matrix3d kEighthTurn =
    Eigen::AngleAxisd(0.25 * 3.14159265358979, Eigen::Vector3d::UnitZ()).toRotationMatrix();

/// `count` links with one or two random shapes each, 2 cm to 30 cm in size.
CycleSetup randomSetup(std::size_t count, unsigned seed);

/// Every link at a random pose within a cube of half edge `reach` [m].
LinkPoses randomLinkPoses(const CycleSetup& setup, double reach, unsigned seed);

/// [m] By PairId, as findNear measures bodies at any distance; NaN where a body is not known.
std::vector<double> allDistances(const CycleSetup& setup, const BodyRows& rows);

}  // namespace collision_monitor::test
