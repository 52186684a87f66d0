// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/Marker.h>

#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/model/world.h"
#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

/// A marker with the shape's type, scale and triangles; pose and color are not set.
visualization_msgs::Marker makeShapeMarker(const Shape& shape);

/// Green, yellow, red, or grey for unknown.
std_msgs::ColorRGBA colourOf(Verdict verdict, float alpha);

/// The worst verdict of the pairs of each link, by LinkId; clear for links without pairs.
void findWorstVerdicts(const CycleSetup& setup, const PairEvents& events,
                       std::vector<Verdict>& verdicts);

/// The shape of a body as it is drawn. A plane, whose body has no end, is a flat box of 10 m.
Shape shownShape(const CycleSetup& setup, const Body& body);

/// Where that shape is drawn.
Pose shownPose(const CycleSetup& setup, std::size_t body, const Pose& world_from_body);

/// The colour of an object.
std_msgs::ColorRGBA colourOf(const World& world, const Link& link);

}  // namespace collision_monitor
