// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/Marker.h>

#include "collision_monitor/geometry/shapes.h"
#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

/// A marker with the shape's type, scale and triangles; pose and color are not set.
visualization_msgs::Marker makeShapeMarker(const Shape& shape);

/// Green, yellow, red, or grey for unknown.
std_msgs::ColorRGBA colourOf(Verdict verdict, float alpha);

/// The worst verdict of the pairs of each link, by LinkId; clear for links without pairs.
void findWorstVerdicts(const CycleSetup& setup, const PairEvents& events,
                       std::vector<Verdict>& verdicts);

}  // namespace collision_monitor
