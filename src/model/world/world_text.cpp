// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/world/world_text.h"

#include <Eigen/Geometry>
#include <cmath>
#include <sstream>

#include "model/rules/yaml_fields.h"
#include "model/world/world_readers.h"

namespace collision_monitor {
namespace {

constexpr const char* kAccepted =
    "YAML with a list of objects, alone or under 'world', or a planning scene of MoveIt";

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Whether it is named as a scene of MoveIt is, or its second line is the first of an object, which
/// is no YAML.
bool isSceneText(const DocumentText& text) {
  std::istringstream lines(text.text);
  std::string line;
  std::getline(lines, line);
  std::getline(lines >> std::ws, line);
  return endsWith(text.source, ".scene") || line.substr(0, 2) == "* ";
}

void readDocument(const YAML::Node& document, const WorldSource& source, const Place& place,
                  std::vector<WorldObject>& objects) {
  const YAML::Node world = childOf(document, "world");
  if (document.IsSequence()) {
    readObjectList(document, source, place, objects);
  } else if (world.IsDefined() && world.IsMap()) {
    readPlanningScene(document, source, place, objects);
  } else if (world.IsDefined() && (world.IsSequence() || world.IsNull())) {
    YamlFields fields(document, place, kAccepted);
    fields.find("world");
    fields.refuseOthers();
    if (world.IsSequence()) {
      readObjectList(world, source, place, objects);
    }
  } else if (world.IsDefined()) {
    place.addError(lineOf(world), "world " + describe(world), kAccepted);
    place.awaitNames();
  } else if (!document.IsNull()) {
    place.addError(lineOf(document), describe(document), kAccepted);
    place.awaitNames();
  }
}

}  // namespace

std::optional<Pose> poseOf(const Eigen::Vector3d& position, const Eigen::Vector4d& quat_xyzw) {
  constexpr double kTolerance = 1e-2;
  const double length = quat_xyzw.norm();
  if (!(std::abs(length - 1.0) <= kTolerance)) {
    return std::nullopt;
  }
  Pose pose;
  pose.rotation = Eigen::Quaterniond(quat_xyzw[3], quat_xyzw[0], quat_xyzw[1], quat_xyzw[2])
                      .normalized()
                      .toRotationMatrix();
  pose.translation = position;
  return pose;
}

SharedMesh loadMesh(const std::string& name, const Eigen::Vector3d& scale, int line,
                    const WorldSource& source, const Place& place) {
  try {
    const StoredMesh& stored = source.meshes.find(name, source.text.directory);
    return std::make_shared<const TriangleMesh>(scaled(stored.mesh, scale));
  } catch (const MeshFault& fault) {
    place.addError(line, fault.what(), fault.accepted);
    return nullptr;
  }
}

std::vector<WorldObject> readWorld(const DocumentText& text, const ResourceLoader& load_resource,
                                   const MeshReading& reading, SetupReport& report) {
  Oddities oddities;
  const Place place(text.source, report, oddities);
  MeshStore meshes(load_resource, reading);
  const WorldSource source{text, meshes};
  std::vector<WorldObject> objects;
  if (text.text.size() > kMostWorldBytes) {
    place.addError(0, std::to_string(text.text.size() >> 20) + " MB of text",
                   "at most " + std::to_string(kMostWorldBytes >> 20) + " MB");
    place.awaitNames();
    return objects;
  }
  if (isSceneText(text)) {
    readSceneText(source, place, objects);
    return objects;
  }
  try {
    readDocument(loadYaml(text.text), source, place, objects);
  } catch (const YAML::Exception& fault) {
    place.addError(fault.mark.line + 1, "text that is no YAML: " + fault.msg, kAccepted);
    place.awaitNames();
  }
  return objects;
}

}  // namespace collision_monitor
