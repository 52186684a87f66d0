// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/Marker.h>

#include <optional>
#include <vector>

#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/model/world.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "ros_edge/parameters/monitor_setup.h"

namespace collision_monitor {

/// A marker with the shape's type, scale and triangles; pose and color are not set.
visualization_msgs::Marker makeShapeMarker(const Shape& shape);

/// A colour of a verdict, of the palette of Okabe and Ito that colour-blind people can tell apart:
/// sky blue for clear, yellow for a warning, vermilion for a contact; dark grey for unknown.
/// Source: docs/references.md.
std_msgs::ColorRGBA colourOf(Verdict verdict, float alpha);

/// What is drawn of a body: the enclosing shape of a link, the geometry of an object. A plane,
/// which has no end, is a flat box of 10 m. Padding is drawn, but not of cones and meshes. Meshes
/// are drawn as drawMeshes says, those without triangles there as the box around them.
struct ShownShape {
  visualization_msgs::Marker marker;  ///< with namespace and id; pose and colour are not set
  Pose link_from_marker;
  std::optional<std_msgs::ColorRGBA> own_colour;  ///< of an object
};

/// By BodyId, which are the ids of the markers.
std::vector<ShownShape> showShapes(const MonitorSetup& setup);

}  // namespace collision_monitor
