// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>

#include "model/mesh_loading/mesh_store.h"
#include "model/number_text.h"
#include "model/place.h"
#include "model/world/world_readers.h"
#include "ros_edge/world/convert_objects.h"

/// From messages.
namespace collision_monitor {
namespace {

using shape_msgs::SolidPrimitive;

/// Converts one object, and adds its faults.
class ObjectReader {
 public:
  ObjectReader(const SceneObject& message, const std::string& where, MeshStore& meshes,
               SetupReport& report)
      : message_(message), where_(where), meshes_(meshes), report_(report) {}

  /// @param is_whole false: name, frame, pose and touch links are all that counts
  WorldObject read(bool is_whole, bool has_pose) {
    WorldObject object;
    object.name = message_.name;
    object.frame = message_.frame_id;
    object.touch_links = message_.touch_links;
    if (has_pose) {
      object.frame_from_object = readPose(message_.pose, where_);
    }
    if (!is_whole) {
      return object;
    }
    object.is_attached = message_.attached != 0;
    object.padding = message_.padding;
    object.group = message_.group;
    const std_msgs::ColorRGBA& colour = message_.colour;
    if (colour.r != 0.0F || colour.g != 0.0F || colour.b != 0.0F || colour.a != 0.0F) {
      object.colour = {colour.r, colour.g, colour.b, colour.a};
    }
    const std::size_t before = report_.errors.size();
    readShapes();
    object.lacks_shapes = report_.errors.size() > before;
    object.shapes = std::make_shared<const ObjectShapes>(std::move(shapes_));
    return object;
  }

 private:
  void refuse(const std::string& where, const std::string& found, const std::string& accepted) {
    report_.errors.push_back({where, found, accepted});
  }

  Pose readPose(const geometry_msgs::Pose& pose, const std::string& where) {
    const auto& p = pose.position;
    const auto& q = pose.orientation;
    const auto read = poseOf({p.x, p.y, p.z}, {q.x, q.y, q.z, q.w});
    if (!read) {
      refuse(where,
             "orientation " + shortText(q.x) + " " + shortText(q.y) + " " + shortText(q.z) + " " +
                 shortText(q.w),
             "a unit quaternion; 0 0 0 1 for none");
    }
    return read.value_or(Pose());
  }

  /// Adds the shapes of one kind. `make(i, where)` gives the geometry of the i-th, or nothing.
  template <class Make>
  void addShapes(std::size_t count, const std::vector<geometry_msgs::Pose>& poses,
                 const std::string& kind, const Make& make) {
    if (poses.size() > count) {
      refuse(where_,
             std::to_string(poses.size()) + " poses for " + std::to_string(count) + " " + kind +
                 (kind == "mesh" ? "es" : "s"),
             "at most one pose a shape");
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::string where = where_ + ", " + kind + " " + std::to_string(i + 1);
      ObjectShape shape;
      if (i < poses.size()) {
        shape.object_from_shape = readPose(poses[i], where);
      }
      if (const std::optional<ObjectGeometry> geometry = make(i, where)) {
        shape.geometry = *geometry;
        shapes_.push_back(std::move(shape));
      }
    }
  }

  void readShapes() {
    addShapes(message_.primitives.size(), message_.primitive_poses, "primitive",
              [&](std::size_t i, const std::string& where) {
                return readPrimitive(message_.primitives[i], where);
              });
    addShapes(message_.meshes.size(), message_.mesh_poses, "mesh",
              [&](std::size_t i, const std::string& /*where*/) {
                return std::optional<ObjectGeometry>(readMesh(message_.meshes[i]));
              });
    addShapes(message_.mesh_files.size(), message_.mesh_file_poses, "mesh file",
              [&](std::size_t i, const std::string& where) { return readFile(i, where); });
    addShapes(message_.planes.size(), message_.plane_poses, "plane",
              [&](std::size_t i, const std::string& /*where*/) {
                const auto& c = message_.planes[i].coef;
                return std::optional<ObjectGeometry>(Plane{{c[0], c[1], c[2]}, -c[3]});
              });
  }

  std::optional<ObjectGeometry> readPrimitive(const SolidPrimitive& primitive,
                                              const std::string& where) {
    const auto& sizes = primitive.dimensions;
    switch (primitive.type) {
      case SolidPrimitive::BOX:
        if (sizes.size() == 3) {
          return Box{{0.5 * sizes[0], 0.5 * sizes[1], 0.5 * sizes[2]}};
        }
        break;
      case SolidPrimitive::SPHERE:
        if (sizes.size() == 1) {
          return Sphere{sizes[0]};
        }
        break;
      case SolidPrimitive::CYLINDER:
        if (sizes.size() == 2) {
          return Cylinder{0.5 * sizes[0], sizes[1]};
        }
        break;
      case SolidPrimitive::CONE:
        if (sizes.size() == 2) {
          return Cone{0.5 * sizes[0], sizes[1]};
        }
        break;
      case SceneObject::CAPSULE:
        if (sizes.size() == 2) {
          return Capsule{0.5 * sizes[0], sizes[1]};
        }
        break;
      default:
        refuse(where, "type " + std::to_string(primitive.type),
               "1 (box), 2 (sphere), 3 (cylinder), 4 (cone) or 100 (capsule)");
        return std::nullopt;
    }
    refuse(where, counted(sizes.size(), "dimension"),
           "3 of a box, 1 of a sphere, 2 of a cylinder, cone or capsule");
    return std::nullopt;
  }

  static SharedMesh readMesh(const shape_msgs::Mesh& message) {
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices.reserve(message.vertices.size());
    for (const geometry_msgs::Point& vertex : message.vertices) {
      mesh->vertices.emplace_back(vertex.x, vertex.y, vertex.z);
    }
    mesh->triangles.reserve(message.triangles.size());
    for (const shape_msgs::MeshTriangle& triangle : message.triangles) {
      const auto& corners = triangle.vertex_indices;
      mesh->triangles.push_back({corners[0], corners[1], corners[2]});
    }
    return mesh;
  }

  std::optional<ObjectGeometry> readFile(std::size_t i, const std::string& where) {
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();
    if (i < message_.mesh_scales.size()) {
      const geometry_msgs::Vector3& told = message_.mesh_scales[i];
      scale = {told.x, told.y, told.z};
    }
    try {
      const StoredMesh& stored = meshes_.find(message_.mesh_files[i], "");
      return std::optional<ObjectGeometry>(
          std::make_shared<const TriangleMesh>(scaled(stored.mesh, scale)));
    } catch (const MeshFault& fault) {
      refuse(where, fault.what(), fault.accepted);
      return std::nullopt;
    }
  }

  const SceneObject& message_;
  const std::string& where_;
  MeshStore& meshes_;
  SetupReport& report_;
  ObjectShapes shapes_;
};

bool isWhole(ChangeKind kind) { return kind == ChangeKind::add || kind == ChangeKind::replace_all; }

}  // namespace

std::vector<ObjectChange> fromMessages(const std::vector<SceneChange>& messages,
                                       const ObjectFiles& files, SetupReport& report) {
  constexpr std::uint8_t kLast = SceneChange::DETACH;
  constexpr std::size_t kMostFaults = 100;
  MeshStore meshes(files.load_resource, files.meshes);
  std::vector<ObjectChange> changes;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const std::string number = "change " + std::to_string(i + 1);
    if (messages[i].kind > kLast) {
      report.errors.push_back(
          {number, "kind " + std::to_string(messages[i].kind), "from 0 (ADD) to 6 (DETACH)"});
      continue;
    }
    ObjectChange change;
    change.kind = static_cast<ChangeKind>(messages[i].kind);
    if (messages[i].objects.size() > kMostObjects) {
      report.errors.push_back({number + " (" + nameOf(change.kind) + ")",
                               std::to_string(messages[i].objects.size()) + " objects",
                               "at most " + std::to_string(kMostObjects)});
      continue;
    }
    change.has_poses = messages[i].where_it_stands == 0;
    const bool has_pose = isWhole(change.kind) || change.kind == ChangeKind::move ||
                          (change.kind == ChangeKind::attach && change.has_poses);
    for (const SceneObject& message : messages[i].objects) {
      if (report.errors.size() > kMostFaults) {
        return changes;
      }
      const std::string where =
          number + " (" + nameOf(change.kind) + "), object " + quoted(message.name);
      change.objects.push_back(
          ObjectReader(message, where, meshes, report).read(isWhole(change.kind), has_pose));
    }
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace collision_monitor
