// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/world/convert_objects.h"

#include "ros_edge/outputs/conversions.h"

/// To messages.
namespace collision_monitor {
namespace {

/// Adds one shape to a message.
struct AddShape {
  const Pose& object_from_shape;
  SceneObject& message;

  geometry_msgs::Pose pose() const {
    geometry_msgs::Pose told;
    toMessage(object_from_shape, told);
    return told;
  }

  void addPrimitive(std::uint8_t type, std::vector<double> dimensions) const {
    message.primitives.emplace_back();
    message.primitives.back().type = type;
    message.primitives.back().dimensions = std::move(dimensions);
    message.primitive_poses.push_back(pose());
  }

  void operator()(const Sphere& sphere) const {
    addPrimitive(shape_msgs::SolidPrimitive::SPHERE, {sphere.radius});
  }
  void operator()(const Capsule& capsule) const {
    addPrimitive(SceneObject::CAPSULE, {2.0 * capsule.half_length, capsule.radius});
  }
  void operator()(const Box& box) const {
    const Eigen::Vector3d size = 2.0 * box.half_extents;
    addPrimitive(shape_msgs::SolidPrimitive::BOX, {size.x(), size.y(), size.z()});
  }
  void operator()(const Cylinder& cylinder) const {
    addPrimitive(shape_msgs::SolidPrimitive::CYLINDER,
                 {2.0 * cylinder.half_length, cylinder.radius});
  }
  void operator()(const Cone& cone) const {
    addPrimitive(shape_msgs::SolidPrimitive::CONE, {2.0 * cone.half_length, cone.radius});
  }
  void operator()(const Plane& plane) const {
    message.planes.emplace_back();
    message.planes.back().coef = {plane.normal.x(), plane.normal.y(), plane.normal.z(),
                                  -plane.offset};
    message.plane_poses.push_back(pose());
  }
  void operator()(const SharedMesh& mesh) const {
    message.meshes.emplace_back();
    shape_msgs::Mesh& told = message.meshes.back();
    told.vertices.resize(mesh->vertices.size());
    for (std::size_t i = 0; i < told.vertices.size(); ++i) {
      toMessage(mesh->vertices[i], told.vertices[i]);
    }
    told.triangles.resize(mesh->triangles.size());
    for (std::size_t i = 0; i < told.triangles.size(); ++i) {
      const auto& corners = mesh->triangles[i];
      told.triangles[i].vertex_indices = {corners[0], corners[1], corners[2]};
    }
    message.mesh_poses.push_back(pose());
  }
};

}  // namespace

void toMessage(const WorldObject& object, SceneObject& message) {
  message.name = object.name;
  message.frame_id = object.frame;
  toMessage(object.frame_from_object, message.pose);
  for (const ObjectShape& shape : *object.shapes) {
    std::visit(AddShape{shape.object_from_shape, message}, shape.geometry);
  }
  message.padding = object.padding;
  message.group = object.group;
  message.colour.r = object.colour[0];
  message.colour.g = object.colour[1];
  message.colour.b = object.colour[2];
  message.colour.a = object.colour[3];
  message.attached = object.is_attached ? 1 : 0;
  message.touch_links = object.touch_links;
}

SceneObjects listOf(const MonitorSetup& setup) {
  SceneObjects message;
  message.header = makeHeader(0, setup.world_frame);
  message.header.stamp = ros::Time::now();
  message.objects.reserve(setup.world.objects.size());
  for (const auto& [name, object] : setup.world.objects) {
    message.objects.emplace_back();
    toMessage(*object, message.objects.back());
  }
  for (const WorldObject& object : setup.held_back) {
    message.waiting.push_back(object.name);
  }
  return message;
}

}  // namespace collision_monitor
