// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/world/prepare_object.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "collision_monitor/geometry/bounds.h"
#include "geometry/all_cores.h"
#include "geometry/hulls/cone_corners.h"
#include "geometry/hulls/convex_hull.h"
#include "geometry/interruption.h"
#include "geometry/meshes/used_vertices.h"
#include "pipeline/setup/fill_element.h"

namespace collision_monitor {
namespace {

/// An enclosing shape that needs no proof.
Enclosure simple(const Shape& shape, const Pose& geometry_from_body, bool is_exact) {
  Enclosure enclosure;
  enclosure.shape = shape;
  enclosure.geometry_from_body = geometry_from_body;
  enclosure.is_exact = is_exact;
  enclosure.overshoot = {std::nan(""), std::nan(""), std::nan("")};
  return enclosure;
}

/// The box along the axes of points, grown by more than rounding.
Enclosure boxAround(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d least = points.front();
  Eigen::Vector3d most = points.front();
  for (const Eigen::Vector3d& point : points) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  constexpr double kRounding = 1e-14;
  Pose center;
  center.translation = 0.5 * (least + most);
  const double growth = kRounding * (least.cwiseAbs().cwiseMax(most.cwiseAbs()).maxCoeff());
  return simple(Box{0.5 * (most - least) + Eigen::Vector3d::Constant(growth)}, center, false);
}

/// A rotation whose third column is this unit vector. Eigen's FromTwoVectors gives none where the
/// vector is nearly opposite to z.
Eigen::Matrix3d frameAlong(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d across =
      std::abs(normal.x()) < 0.8 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  Eigen::Matrix3d frame;
  frame.col(2) = normal;
  frame.col(0) = (across - normal * normal.dot(across)).normalized();
  frame.col(1) = normal.cross(frame.col(0)).normalized();
  return frame;
}

/// Places a half space z <= 0 in the frame of the plane, as near to its origin as the plane is.
Pose placeOf(const Plane& plane) {
  const double length = plane.normal.norm();
  const Eigen::Vector3d normal = plane.normal / length;
  Pose shape_from_plane;
  shape_from_plane.rotation = frameAlong(normal);
  shape_from_plane.translation = plane.offset / length * normal;
  return shape_from_plane;
}

/// Fills the element of a geometry, and finds a shape around it.
struct Fill {
  RefineGeometry refine;
  Element& element;
  std::string kind{};

  Enclosure fillExact(const Geometry& geometry, const Shape& shape) {
    fillElement(geometry, refine, element);
    element.inner = inscribeShapes(geometry);
    return simple(shape, Pose(), true);
  }

  Enclosure operator()(const Sphere& sphere) {
    kind = "sphere";
    return fillExact(sphere, sphere);
  }
  Enclosure operator()(const Capsule& capsule) {
    kind = "capsule";
    return fillExact(capsule, capsule);
  }
  Enclosure operator()(const Box& box) {
    kind = "box";
    return fillExact(box, box);
  }
  Enclosure operator()(const Cylinder& cylinder) {
    kind = "cylinder";
    fillExact(cylinder, Sphere{});
    return simple(Box{{cylinder.radius, cylinder.radius, cylinder.half_length}}, Pose(), false);
  }
  Enclosure operator()(const Cone& cone) {
    kind = "cone";
    const std::vector<Eigen::Vector3d> corners = cornersAroundCone(cone.radius, cone.half_length);
    fillElement(convexHullOf(corners), RefineGeometry::hull, element);
    element.is_exact = false;
    return boxAround(corners);
  }
  Enclosure operator()(const SharedMesh& mesh) {
    kind = "mesh";
    fillElement(*mesh, refine == RefineGeometry::none ? RefineGeometry::hull : refine, element);
    const std::optional<TriangleMesh> used = withoutUnusedVertices(*mesh);
    return boxAround(used ? used->vertices : mesh->vertices);
  }
  Enclosure operator()(const Plane& plane) {
    kind = "plane";
    element.convex = HalfSpace();
    element.is_exact = true;
    element.link_from_element = placeOf(plane);
    Pose plane_from_box;
    plane_from_box.translation.z() = kPlaneWidening - kPlaneReach;
    return simple(Box{Eigen::Vector3d::Constant(kPlaneReach)},
                  element.link_from_element * plane_from_box, false);
  }
};

void addShape(const ObjectShape& shape, const std::string& number, RefineGeometry refine,
              PreparedObject& object) {
  Element element;
  Fill fill{refine, element};
  const Enclosure enclosure = std::visit(fill, shape.geometry);
  const bool is_exact = enclosure.is_exact && object.padding == 0.0;
  element.name = fill.kind + number;
  element.link_from_element = shape.object_from_shape * element.link_from_element;
  element.padding = object.padding;
  element.is_body = is_exact;
  Body body;
  body.link_from_body = shape.object_from_shape * enclosure.geometry_from_body;
  body.shape = object.padding > 0.0 ? grown(enclosure.shape, object.padding) : enclosure.shape;
  body.bounding_radius = boundingRadius(body.shape);
  body.is_exact = is_exact;
  body.element = idAt<ElementId>(object.elements.size());
  BodyLabel label;
  label.shape_name = element.name + "/" + kindName(body.shape);
  label.overshoot = enclosure.overshoot;
  if (!isRigid(body.link_from_body) || !isRigid(element.link_from_element)) {
    throw std::logic_error(element.name + " would stand in a pose that is no rotation");
  }
  object.elements.push_back(std::move(element));
  object.bodies.push_back(body);
  object.labels.push_back(std::move(label));
}

}  // namespace

std::shared_ptr<const PreparedObject> prepareObject(const WorldObject& object,
                                                    RefineGeometry refine) {
  auto prepared = std::make_shared<PreparedObject>();
  prepared->shapes = object.shapes;
  prepared->padding = object.padding;
  for (std::size_t i = 0; i < object.shapes->size(); ++i) {
    const std::string number = object.shapes->size() == 1 ? "" : "_" + std::to_string(i + 1);
    try {
      addShape((*object.shapes)[i], number, refine, *prepared);
    } catch (const std::exception& fault) {
      throw SetupError({{object.where.empty() ? "world" : object.where,
                         "object '" + object.name + "': " + fault.what(), ""}});
    }
  }
  return prepared;
}

PreparedObjects prepareObjects(const World& world, RefineGeometry refine,
                               const PreparedObjects& former) {
  PreparedObjects all;
  std::vector<std::pair<const WorldObject*, std::shared_ptr<const PreparedObject>*>> missing;
  for (const auto& [name, object] : world.objects) {
    const auto known = former.find(name);
    const bool is_ready = known != former.end() && known->second->shapes == object->shapes &&
                          known->second->padding == object->padding;
    auto& place = all.emplace_hint(all.end(), name, is_ready ? known->second : nullptr)->second;
    if (!is_ready) {
      missing.emplace_back(object.get(), &place);
    }
  }
  forEachOnAllCores(missing.size(), [&](std::size_t i) {
    throwIfInterrupted();
    *missing[i].second = prepareObject(*missing[i].first, refine);
  });
  return all;
}

}  // namespace collision_monitor
