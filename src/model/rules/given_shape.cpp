// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/rules/given_shape.h"

#include <array>
#include <charconv>
#include <string>

#include "geometry/bvh/visit_held.h"
#include "geometry/rpy.h"
#include "model/rules/yaml_fields.h"

namespace collision_monitor {
namespace {

constexpr double kMaxLength = 1e6;  // [m]
constexpr double kMaxAngle = 1e3;   // [rad]
const char* const kKinds = "sphere, capsule, box or rounded_box";

/// Reads the fields of this kind only. Others are faults: a box's radius would have no effect.
std::optional<Shape> readShape(const std::string& kind, YamlFields& fields) {
  const auto needed = [&](const char* key, int count) {
    return fields.readLengths(key, count, 0.0, kMaxLength);
  };
  if (kind == "sphere") {
    return Sphere{needed("radius", 1)[0]};
  }
  if (kind == "capsule") {
    return Capsule{0.5 * needed("length", 1)[0], needed("radius", 1)[0]};
  }
  if (kind == "box") {
    return Box{0.5 * needed("size", 3)};
  }
  if (kind == "rounded_box") {
    return RoundedBox{0.5 * needed("size", 3), needed("radius", 1)[0]};
  }
  fields.refuse("kind", kKinds);
  return std::nullopt;
}

Pose readPose(YamlFields& fields) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(3);
  Pose pose;
  pose.translation = fields.readNumbers("xyz", 3, -kMaxLength, kMaxLength).value_or(zero);
  const Eigen::Vector3d rpy = fields.readNumbers("rpy", 3, -kMaxAngle, kMaxAngle).value_or(zero);
  pose.rotation = rotationOfRpy(rpy);
  return pose;
}

/// With nine digits, the same in every locale.
std::string number(double value) {
  constexpr int kDigits = 9;
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, kDigits)
                       .ptr;
  return {text.data(), end};
}

std::string list(const Eigen::Vector3d& values) {
  return "[" + number(values.x()) + ", " + number(values.y()) + ", " + number(values.z()) + "]";
}

}  // namespace

std::optional<PosedShape> readGivenShape(const YAML::Node& node, const Place& place) {
  const std::string accepted = std::string("a shape with its kind, ") + kKinds;
  YamlFields fields(node, place, accepted);
  if (!node.IsMap()) {
    return std::nullopt;
  }
  const std::optional<std::string> kind = fields.readText("kind", kKinds);
  if (!kind) {
    if (!fields.find("kind")) {
      place.addError(lineOf(node), "a shape without kind", accepted);
    }
    return std::nullopt;
  }
  const std::optional<Shape> shape = readShape(*kind, fields);
  const Pose link_from_body = readPose(fields);
  if (!shape) {
    return std::nullopt;
  }
  fields.refuseOthers();
  return PosedShape{*shape, link_from_body};
}

std::string toYaml(const PosedShape& shape) {
  struct {
    std::string operator()(const Sphere& s) const { return ", radius: " + number(s.radius); }
    std::string operator()(const Capsule& s) const {
      return ", radius: " + number(s.radius) + ", length: " + number(2.0 * s.half_length);
    }
    std::string operator()(const Box& s) const { return ", size: " + list(2.0 * s.half_extents); }
    std::string operator()(const RoundedBox& s) const {
      return ", size: " + list(2.0 * s.half_extents) + ", radius: " + number(s.radius);
    }
  } dimensions;
  std::string text = std::string("{kind: ") + kindName(shape.shape);
  text += visitHeld(dimensions, shape.shape);
  text += ", xyz: " + list(shape.geometry_from_body.translation);
  text += ", rpy: " + list(rpyOf(shape.geometry_from_body.rotation)) + "}";
  return text;
}

}  // namespace collision_monitor
