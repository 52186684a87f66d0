// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/number_text.h"
#include "model/rules/yaml_fields.h"
#include "model/world/world_readers.h"

/// Planning scenes of MoveIt in YAML, as written from its messages. What is no object is skipped.
namespace collision_monitor {
namespace {

std::string shown(const YAML::Node& node) { return node.IsDefined() ? describe(node) : "nothing"; }

std::string textOf(const YAML::Node& node) {
  if (!node.IsDefined() || !node.IsScalar()) {
    return "";
  }
  const std::vector<std::string_view> words = wordsOf(node.Scalar());
  return words.empty()
             ? ""
             : std::string(words.front().data(), words.back().data() + words.back().size());
}

/// Numbers as a list, or as a map of x, y, z (and w); nothing if they are not that many.
std::optional<Eigen::VectorXd> numbersOf(const YAML::Node& node, std::size_t count) {
  constexpr const char* kAxes[] = {"x", "y", "z", "w"};
  const bool is_list = node.IsDefined() && node.IsSequence() && node.size() == count;
  Eigen::VectorXd numbers(static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const YAML::Node item = is_list ? node[i] : childOf(node, kAxes[i % 4]);
    Eigen::VectorXd number(1);
    if (!item.IsDefined() || !item.IsScalar() || parseNumbers(item.Scalar(), number)) {
      return std::nullopt;
    }
    numbers[static_cast<Eigen::Index>(i)] = number[0];
  }
  return numbers;
}

/// Reads the objects of one scene.
class SceneReader {
 public:
  SceneReader(const WorldSource& source, std::vector<WorldObject>& objects)
      : source_(source), objects_(objects) {}

  void readList(const YAML::Node& list, bool are_attached, const Place& place) {
    if (!list.IsDefined() || list.IsNull()) {
      return;
    }
    if (!list.IsSequence()) {
      place.addError(lineOf(list), describe(list), "a list of objects");
      return;
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Place own = place.within("object " + std::to_string(i + 1));
      const YAML::Node attached = list[i];
      const YAML::Node node = are_attached ? childOf(attached, "object") : attached;
      if (!node.IsDefined() || !node.IsMap()) {
        own.addError(lineOf(attached), describe(attached), "an object with its fields");
        continue;
      }
      WorldObject object = readObject(node, own);
      if (are_attached) {
        object.is_attached = true;
        const std::string carrier = textOf(childOf(attached, "link_name"));
        const std::string& frame = object.frame;
        if (!frame.empty() && frame != carrier) {
          own.addError(lineOf(node), "frame_id " + quoted(frame),
                       quoted(carrier) + ", the link that the object is attached to");
        }
        object.frame = carrier;
        for (const YAML::Node& link : childOf(attached, "touch_links")) {
          object.touch_links.push_back(textOf(link));
        }
      }
      objects_.push_back(std::move(object));
    }
  }

 private:
  WorldObject readObject(const YAML::Node& node, const Place& place) {
    WorldObject object;
    object.name = textOf(childOf(node, "id"));
    object.where = source_.at(lineOf(node));
    object.frame = textOf(childOf(childOf(node, "header"), "frame_id"));
    if (const YAML::Node pose = childOf(node, "pose"); pose.IsDefined()) {
      object.frame_from_object = readPose(pose, place);
    }
    ObjectShapes shapes;
    for (const char* kind : {"primitive", "mesh", "plane"}) {
      object.lacks_shapes = readShapes(node, kind, place, shapes) || object.lacks_shapes;
    }
    object.shapes = std::make_shared<const ObjectShapes>(std::move(shapes));
    return object;
  }

  /// @return whether one could not be read
  bool readShapes(const YAML::Node& node, const std::string& kind, const Place& place,
                  ObjectShapes& shapes) {
    bool is_any_missing = false;
    const YAML::Node list = childOf(node, kind + (kind == "mesh" ? "es" : "s"));
    const YAML::Node poses = childOf(node, kind + "_poses");
    for (std::size_t i = 0; list.IsDefined() && list.IsSequence() && i < list.size(); ++i) {
      const Place own = place.within(kind + " " + std::to_string(i + 1));
      ObjectShape shape;
      if (poses.IsDefined() && poses.IsSequence() && i < poses.size()) {
        shape.object_from_shape = readPose(poses[i], own);
      }
      const YAML::Node item = list[i];
      const std::optional<ObjectGeometry> geometry = kind == "primitive" ? readPrimitive(item, own)
                                                     : kind == "mesh"    ? readMesh(item, own)
                                                                         : readPlane(item, own);
      if (geometry) {
        shape.geometry = *geometry;
        shapes.push_back(std::move(shape));
      }
      is_any_missing = is_any_missing || !geometry;
    }
    return is_any_missing;
  }

  static Pose readPose(const YAML::Node& node, const Place& place) {
    const auto position = numbersOf(childOf(node, "position"), 3);
    const auto orientation = numbersOf(childOf(node, "orientation"), 4);
    const std::optional<Pose> pose =
        position && orientation ? poseOf(*position, *orientation) : std::nullopt;
    if (!pose) {
      place.addError(lineOf(node), "a pose that cannot be read",
                     "position with three numbers and orientation with a unit quaternion");
    }
    return pose.value_or(Pose());
  }

  static std::optional<ObjectGeometry> readPrimitive(const YAML::Node& node, const Place& place) {
    const std::string type = textOf(childOf(node, "type"));
    const YAML::Node dimensions = childOf(node, "dimensions");
    const auto sizes = [&](std::size_t count) { return numbersOf(dimensions, count); };
    if (type == "box" || type == "1") {
      if (const auto size = sizes(3)) {
        return Box{0.5 * *size};
      }
    } else if (type == "sphere" || type == "2") {
      if (const auto size = sizes(1)) {
        return Sphere{(*size)[0]};
      }
    } else if (type == "cylinder" || type == "3") {
      if (const auto size = sizes(2)) {
        return Cylinder{0.5 * (*size)[0], (*size)[1]};
      }
    } else if (type == "cone" || type == "4") {
      if (const auto size = sizes(2)) {
        return Cone{0.5 * (*size)[0], (*size)[1]};
      }
    }
    place.addError(lineOf(node),
                   "a primitive of type " + quoted(type) + " with dimensions " + shown(dimensions),
                   "box with 3 dimensions, sphere with 1, cylinder or cone with 2");
    return std::nullopt;
  }

  std::optional<ObjectGeometry> readMesh(const YAML::Node& node, const Place& place) const {
    const std::string resource = textOf(childOf(node, "resource"));
    if (resource.empty()) {
      return readTriangles(node, place);
    }
    const YAML::Node dimensions = childOf(node, "dimensions");
    const auto scale = dimensions.IsDefined()
                           ? numbersOf(dimensions, 3)
                           : std::optional<Eigen::VectorXd>(Eigen::VectorXd::Ones(3));
    if (!scale) {
      place.addError(lineOf(dimensions), "dimensions " + describe(dimensions), "three numbers");
      return std::nullopt;
    }
    const SharedMesh mesh = loadMesh(resource, *scale, lineOf(node), source_, place);
    return mesh ? std::optional<ObjectGeometry>(mesh) : std::nullopt;
  }

  static std::optional<ObjectGeometry> readTriangles(const YAML::Node& node, const Place& place) {
    auto mesh = std::make_shared<TriangleMesh>();
    for (const YAML::Node& vertex : childOf(node, "vertices")) {
      const auto point = numbersOf(vertex, 3);
      mesh->vertices.emplace_back(point ? Eigen::Vector3d(*point)
                                        : Eigen::Vector3d::Constant(2.0 * kFarthestObject));
    }
    for (const YAML::Node& triangle : childOf(node, "triangles")) {
      const YAML::Node indices = childOf(triangle, "vertex_indices");
      const auto corners = numbersOf(indices.IsDefined() ? indices : triangle, 3);
      constexpr double kMostVertices = 4294967295.0;
      const bool are_whole = corners && (corners->array() >= 0.0).all() &&
                             (corners->array() < kMostVertices).all() &&
                             (corners->array() == corners->array().floor()).all();
      if (!are_whole) {
        place.addError(lineOf(triangle), "triangle " + describe(triangle),
                       "three numbers of vertices");
        return std::nullopt;
      }
      const auto at = [&](Eigen::Index i) { return static_cast<std::uint32_t>((*corners)[i]); };
      mesh->triangles.push_back({at(0), at(1), at(2)});
    }
    return mesh;
  }

  static std::optional<ObjectGeometry> readPlane(const YAML::Node& node, const Place& place) {
    const auto numbers = numbersOf(childOf(node, "coef"), 4);
    if (!numbers) {
      place.addError(lineOf(node), describe(node), "coef with four numbers");
      return std::nullopt;
    }
    return Plane{numbers->head<3>(), -(*numbers)[3]};
  }

  const WorldSource& source_;
  std::vector<WorldObject>& objects_;
};

}  // namespace

void readPlanningScene(const YAML::Node& document, const WorldSource& source, const Place& place,
                       std::vector<WorldObject>& objects) {
  SceneReader reader(source, objects);
  reader.readList(childOf(document["world"], "collision_objects"), false, place);
  reader.readList(childOf(childOf(document, "robot_state"), "attached_collision_objects"), true,
                  place.within("attached"));
}

}  // namespace collision_monitor
