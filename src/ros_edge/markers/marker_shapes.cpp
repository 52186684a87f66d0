// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/marker_shapes.h"

#include <algorithm>

#include "collision_monitor/geometry/ids.h"
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

namespace {

constexpr double kShownHalf = 5.0;     // [m] of a plane
constexpr double kShownDepth = 0.005;  // [m] half of what is drawn of its inside

bool isPlane(const CycleSetup& setup, const Body& body) {
  const auto& convex = setup.elements[index(body.element)].convex;
  return convex && std::holds_alternative<HalfSpace>(*convex);
}

}  // namespace

Shape shownShape(const CycleSetup& setup, const Body& body) {
  return isPlane(setup, body) ? Shape(Box{{kShownHalf, kShownHalf, kShownDepth}}) : body.shape;
}

Pose shownPose(const CycleSetup& setup, std::size_t body, const Pose& world_from_body) {
  Pose pose = world_from_body;
  if (isPlane(setup, setup.bodies[body])) {
    const double top = coreHalfExtents(setup.bodies[body].shape).z();
    pose.translation += (top - kShownDepth) * pose.rotation.col(2);
  }
  return pose;
}

std_msgs::ColorRGBA colourOf(const World& world, const Link& link) {
  std_msgs::ColorRGBA colour;
  const auto object = world.objects.find(link.name);
  if (object != world.objects.end()) {
    colour.r = object->second->colour[0];
    colour.g = object->second->colour[1];
    colour.b = object->second->colour[2];
    colour.a = object->second->colour[3];
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
