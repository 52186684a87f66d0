// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/rpy.h"
#include "model/rules/yaml_fields.h"
#include "model/world/world_readers.h"

/// Lists of objects in this package's own YAML.
namespace collision_monitor {
namespace {

constexpr const char* kKinds = "sphere, capsule, box, cylinder, cone, mesh or plane";
constexpr double kMaxAngle = 1e3;  // [rad]

/// Reads the fields of one shape, which may stand among those of its object.
class ShapeFields {
 public:
  ShapeFields(YamlFields& fields, const WorldSource& source, const Place& place, int line)
      : fields_(fields), source_(source), place_(place), line_(line) {}

  std::optional<ObjectGeometry> read() {
    const std::optional<std::string> kind = fields_.readText("kind", kKinds);
    if (!kind) {
      if (!fields_.find("kind")) {
        place_.addError(
            line_, "no kind",
            std::string("'kind: box, size: [0.1, 0.2, 0.3]', or another kind: ") + kKinds);
      }
      return std::nullopt;
    }
    return readKind(*kind);
  }

 private:
  Eigen::VectorXd needed(const char* key, int count) {
    return fields_.readLengths(key, count, -kFarthestObject, kFarthestObject);
  }

  std::optional<ObjectGeometry> readKind(const std::string& kind) {
    if (kind == "sphere") {
      return Sphere{needed("radius", 1)[0]};
    }
    if (kind == "capsule") {
      return Capsule{0.5 * needed("length", 1)[0], needed("radius", 1)[0]};
    }
    if (kind == "box") {
      return Box{0.5 * needed("size", 3)};
    }
    if (kind == "cylinder") {
      return Cylinder{0.5 * needed("length", 1)[0], needed("radius", 1)[0]};
    }
    if (kind == "cone") {
      return Cone{0.5 * needed("length", 1)[0], needed("radius", 1)[0]};
    }
    if (kind == "plane") {
      Plane plane;
      plane.normal = fields_.readNumbers("normal", 3, -kFarthestObject, kFarthestObject)
                         .value_or(plane.normal);
      plane.offset =
          fields_.readNumber("offset", -kFarthestObject, kFarthestObject).value_or(plane.offset);
      return plane;
    }
    if (kind == "mesh") {
      return readMesh();
    }
    fields_.refuse("kind", kKinds);
    return std::nullopt;
  }

  std::optional<ObjectGeometry> readMesh() {
    const auto scale = fields_.readNumbers("scale", 3, -kFarthestObject, kFarthestObject);
    const std::optional<std::string> file = fields_.readText("file", "the name of a mesh file");
    if (!file) {
      if (!fields_.find("file")) {
        fields_.refuse("kind", "with file, the name of a mesh file");
      }
      return std::nullopt;
    }
    const SharedMesh mesh =
        loadMesh(*file, scale ? Eigen::Vector3d(*scale) : Eigen::Vector3d::Ones(),
                 lineOf(*fields_.find("file")), source_, place_);
    return mesh ? std::optional<ObjectGeometry>(mesh) : std::nullopt;
  }

  YamlFields& fields_;
  const WorldSource& source_;
  const Place& place_;
  int line_;
};

Pose readPose(YamlFields& fields, const Place& place, int line) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(3);
  Pose pose;
  pose.translation = fields.readNumbers("xyz", 3, -kFarthestObject, kFarthestObject).value_or(zero);
  const auto quaternion = fields.readNumbers("quat_xyzw", 4, -kFarthestObject, kFarthestObject);
  if (!quaternion) {
    pose.rotation =
        rotationOfRpy(fields.readNumbers("rpy", 3, -kMaxAngle, kMaxAngle).value_or(zero));
    return pose;
  }
  if (fields.find("rpy")) {
    place.addError(line, "rpy and quat_xyzw", "one of them");
  }
  const std::optional<Pose> turned = poseOf(pose.translation, *quaternion);
  if (!turned) {
    fields.refuse("quat_xyzw", "a unit quaternion");
  }
  return turned.value_or(pose);
}

/// The shapes of an object: a list, or one whose fields stand among those of the object.
ObjectShapes readShapes(YamlFields& fields, const WorldSource& source, const Place& place,
                        int line) {
  ObjectShapes shapes;
  const std::optional<YAML::Node> list = fields.find("shapes");
  if (!list) {
    if (const auto geometry = ShapeFields(fields, source, place, line).read()) {
      shapes.push_back({Pose(), *geometry});
    }
    return shapes;
  }
  if (!list->IsSequence() || list->size() == 0) {
    fields.refuse("shapes", "a list of shapes, at least one");
    return shapes;
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    const YAML::Node node = (*list)[i];
    const Place inner = place.within("shape " + std::to_string(i + 1));
    YamlFields shape(node, inner, std::string("a shape with its kind: ") + kKinds);
    if (!node.IsMap()) {
      continue;
    }
    const Pose pose = readPose(shape, inner, lineOf(node));
    if (const auto geometry = ShapeFields(shape, source, inner, lineOf(node)).read()) {
      shapes.push_back({pose, *geometry});
      shape.refuseOthers();
    }
  }
  return shapes;
}

void readCarrier(YamlFields& fields, const Place& place, int line, WorldObject& object) {
  const auto link = fields.readText("attach", "the name of a link");
  const auto frame = fields.readText("frame", "the name of a tf frame");
  if (link && frame) {
    place.addError(line, "frame and attach", "one of them");
  }
  object.is_attached = link.has_value();
  object.frame = link.value_or(frame.value_or(""));
  for (const YAML::Node& word : fields.readWords("touch_links", "names of links")) {
    object.touch_links.push_back(word.Scalar());
  }
}

std::optional<WorldObject> readObject(const YAML::Node& node, const WorldSource& source,
                                      const Place& place) {
  YamlFields fields(node, place, "an object with its fields");
  if (!node.IsMap()) {
    return std::nullopt;
  }
  const int line = lineOf(node);
  WorldObject object;
  object.where = source.at(line);
  object.name = fields.readText("name", "a name").value_or("");
  const Place named =
      object.name.empty() ? place : place.within(collision_monitor::quoted(object.name));
  YamlFields rest(node, named, "an object with its fields");
  rest.find("name");
  readCarrier(rest, named, line, object);
  object.frame_from_object = readPose(rest, named, line);
  object.padding = rest.readNumber("padding", 0.0, kMostObjectPadding).value_or(0.0);
  object.group = rest.readText("group", "a name").value_or("");
  if (const auto colour = rest.readNumbers("colour", 4, 0.0, 1.0)) {
    for (std::size_t i = 0; i < object.colour.size(); ++i) {
      object.colour[i] = static_cast<float>((*colour)[static_cast<Eigen::Index>(i)]);
    }
  }
  ObjectShapes shapes = readShapes(rest, source, named, line);
  object.lacks_shapes = shapes.empty();
  if (!object.lacks_shapes) {  // else the fields are those of a shape that is not known
    rest.refuseOthers();
  }
  object.shapes = std::make_shared<const ObjectShapes>(std::move(shapes));
  return object;
}

}  // namespace

void readObjectList(const YAML::Node& list, const WorldSource& source, const Place& place,
                    std::vector<WorldObject>& objects) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto object = readObject(list[i], source, place.within("object " + std::to_string(i + 1)));
    if (!object || object->name.empty()) {
      place.awaitNames();
    }
    if (object) {
      objects.push_back(std::move(*object));
    }
  }
}

}  // namespace collision_monitor
