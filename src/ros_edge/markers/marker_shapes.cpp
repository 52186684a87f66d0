// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/marker_shapes.h"

#include <algorithm>

#include "ros_edge/markers/shape_mesh.h"
#include "ros_edge/outputs/conversions.h"

namespace collision_monitor {

using visualization_msgs::Marker;

visualization_msgs::Marker makeShapeMarker(const Shape& shape) {
  Marker marker;
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    marker.type = Marker::SPHERE;
    toMessage(Eigen::Vector3d::Constant(2.0 * sphere->radius), marker.scale);
    return marker;
  }
  if (const auto* box = std::get_if<Box>(&shape)) {
    marker.type = Marker::CUBE;
    toMessage(2.0 * box->half_extents, marker.scale);
    return marker;
  }
  marker.type = Marker::TRIANGLE_LIST;
  toMessage(Eigen::Vector3d::Ones(), marker.scale);
  const TriangleMesh mesh = surfaceOf(shape);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      marker.points.emplace_back();
      toMessage(mesh.vertices[corner], marker.points.back());
    }
  }
  return marker;
}

std_msgs::ColorRGBA colourOf(Verdict verdict, float alpha) {
  std_msgs::ColorRGBA colour;
  colour.a = alpha;
  switch (verdict) {
    case Verdict::clear:
      colour.g = 0.8F;
      break;
    case Verdict::warning:
      colour.r = 1.0F;
      colour.g = 0.8F;
      break;
    case Verdict::contact:
      colour.r = 1.0F;
      break;
    case Verdict::unknown:
      colour.r = colour.g = colour.b = 0.5F;
      break;
  }
  return colour;
}

void findWorstVerdicts(const CycleSetup& setup, const PairEvents& events,
                       std::vector<Verdict>& verdicts) {
  verdicts.assign(setup.model.links.size(), Verdict::clear);
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    // An unknown pair says nothing about this link: its partner may be the cause.
    if (events.verdicts[i] != Verdict::unknown) {
      Verdict& a = verdicts[index(setup.checked[i].a)];
      Verdict& b = verdicts[index(setup.checked[i].b)];
      a = std::max(a, events.verdicts[i]);
      b = std::max(b, events.verdicts[i]);
    }
  }
}

}  // namespace collision_monitor
