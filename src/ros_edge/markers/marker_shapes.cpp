// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/marker_shapes.h"

#include <algorithm>

#include "collision_monitor/geometry/ids.h"
#include "model/object_links.h"
#include "ros_edge/markers/object_mesh.h"
#include "ros_edge/markers/shape_mesh.h"
#include "ros_edge/outputs/conversions.h"

namespace collision_monitor {

using visualization_msgs::Marker;

namespace {

Marker makeMeshMarker(const TriangleMesh& mesh) {
  Marker marker;
  marker.type = Marker::TRIANGLE_LIST;
  toMessage(Eigen::Vector3d::Ones(), marker.scale);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      marker.points.emplace_back();
      toMessage(mesh.vertices[corner], marker.points.back());
    }
  }
  return marker;
}

}  // namespace

Marker makeShapeMarker(const Shape& shape) {
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
  return makeMeshMarker(surfaceOf(shape));
}

std_msgs::ColorRGBA colourOf(Verdict verdict, float alpha) {
  const auto colour = [&](int red, int green, int blue) {
    std_msgs::ColorRGBA parts;
    parts.r = static_cast<float>(red) / 255.0F;
    parts.g = static_cast<float>(green) / 255.0F;
    parts.b = static_cast<float>(blue) / 255.0F;
    parts.a = alpha;
    return parts;
  };
  switch (verdict) {
    case Verdict::clear:
      return colour(86, 180, 233);
    case Verdict::warning:
      return colour(240, 228, 66);
    case Verdict::contact:
      return colour(213, 94, 0);
    case Verdict::unknown:
      break;
  }
  return colour(90, 90, 90);
}

namespace {

constexpr double kShownHalf = 5.0;     // [m] of a plane
constexpr double kShownDepth = 0.005;  // [m] half of what is drawn of its inside

Marker makeCylinderMarker(const Cylinder& cylinder, double padding) {
  Marker marker;
  marker.type = Marker::CYLINDER;
  const double width = 2.0 * (cylinder.radius + padding);
  toMessage(Eigen::Vector3d(width, width, 2.0 * (cylinder.half_length + padding)), marker.scale);
  return marker;
}

std_msgs::ColorRGBA rgbaOf(const ObjectColour& colour) {
  std_msgs::ColorRGBA message;
  message.r = colour[0];
  message.g = colour[1];
  message.b = colour[2];
  message.a = colour[3];
  return message;
}

/// The part of a plane that is drawn: a flat box that ends where the body does.
ShownShape showPlane(const Body& body) {
  ShownShape shown{makeShapeMarker(Box{{kShownHalf, kShownHalf, kShownDepth}}), body.link_from_body,
                   std::nullopt};
  const double top = coreHalfExtents(body.shape).z() - kShownDepth;
  shown.link_from_marker.translation += top * body.link_from_body.rotation.col(2);
  return shown;
}

/// One of the shapes of an object, and its body.
ShownShape showShape(const WorldObject& object, const ObjectShape& shape, const Body& body,
                     const DrawnMeshes& meshes) {
  ShownShape shown{{}, shape.object_from_shape, std::nullopt};
  if (std::holds_alternative<Plane>(shape.geometry)) {
    shown = showPlane(body);
  } else if (const auto* cylinder = std::get_if<Cylinder>(&shape.geometry)) {
    shown.marker = makeCylinderMarker(*cylinder, object.padding);
  } else if (const auto* cone = std::get_if<Cone>(&shape.geometry)) {
    shown.marker = makeMeshMarker(surfaceOf(*cone));
  } else if (const auto* mesh = std::get_if<SharedMesh>(&shape.geometry)) {
    const TriangleMesh& drawn = *meshes.at(*mesh).drawn;
    if (drawn.triangles.empty()) {
      shown = {makeShapeMarker(body.shape), body.link_from_body, std::nullopt};
    } else {
      shown.marker = makeMeshMarker(drawn);
    }
  } else {
    shown.marker = makeShapeMarker(body.shape);
  }
  shown.marker.ns = "objects";
  shown.own_colour = rgbaOf(object.colour);
  return shown;
}

}  // namespace

std::vector<ShownShape> showShapes(const MonitorSetup& watched) {
  const CycleSetup& setup = watched.setup;
  std::vector<ShownShape> shapes;
  shapes.reserve(setup.bodies.size());
  std::size_t first = 0;  // body of the same link; an object has one for each of its shapes
  for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
    const Body& body = setup.bodies[i];
    first = setup.bodies[first].link == body.link ? first : i;
    if (isObject(setup.model, body.link)) {
      const WorldObject& object = *watched.world.objects.at(setup.model.link(body.link).name);
      shapes.push_back(showShape(object, object.shapes->at(i - first), body, watched.drawn));
    } else {
      shapes.push_back({makeShapeMarker(body.shape), body.link_from_body, std::nullopt});
      shapes.back().marker.ns = "shapes";
    }
    shapes.back().marker.id = static_cast<int>(i);
  }
  return shapes;
}

}  // namespace collision_monitor
