// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/world/check_object.h"

#include <cmath>
#include <stdexcept>

#include "geometry/meshes/check_mesh.h"
#include "model/number_text.h"
#include "model/place.h"

namespace collision_monitor {
namespace {

std::string textOf(const Eigen::Vector3d& v) {
  return "(" + shortText(v.x()) + ", " + shortText(v.y()) + ", " + shortText(v.z()) + ")";
}

/// Adds the faults of one geometry.
struct GeometryCheck {
  const std::string& where;
  SetupReport& report;

  void refuse(const std::string& found, const std::string& accepted) const {
    report.errors.push_back({where, found, accepted});
  }

  void checkLength(const char* name, double length) const {
    if (!(length > 0.0 && length <= kFarthestObject)) {
      refuse(name + (" " + shortText(length)) + " m",
             "a length greater than 0, up to " + shortText(kFarthestObject) + " m");
    }
  }

  void operator()(const Sphere& sphere) const { checkLength("sphere radius", sphere.radius); }
  void operator()(const Capsule& capsule) const {
    checkLength("capsule radius", capsule.radius);
    checkLength("capsule length", 2.0 * capsule.half_length);
  }
  void operator()(const Box& box) const {
    checkLength("box size along x", 2.0 * box.half_extents.x());
    checkLength("box size along y", 2.0 * box.half_extents.y());
    checkLength("box size along z", 2.0 * box.half_extents.z());
  }
  void operator()(const Cylinder& cylinder) const {
    checkLength("cylinder radius", cylinder.radius);
    checkLength("cylinder length", 2.0 * cylinder.half_length);
  }
  void operator()(const Cone& cone) const {
    checkLength("cone radius", cone.radius);
    checkLength("cone height", 2.0 * cone.half_length);
  }
  void operator()(const Plane& plane) const {
    constexpr double kShortest = 1e-6;
    constexpr double kLongest = 1e6;
    const double length = plane.normal.norm();
    if (!(length >= kShortest && length <= kLongest)) {
      refuse("plane normal " + textOf(plane.normal), "a direction: three numbers, not all 0");
    } else if (!(std::abs(plane.offset) <= kFarthestObject * length)) {
      refuse("plane offset " + shortText(plane.offset),
             "a plane up to " + shortText(kFarthestObject) + " m from the object's origin");
    }
  }
  void operator()(const SharedMesh& mesh) const {
    if (!mesh || mesh->triangles.empty()) {
      refuse("a mesh without triangles", "at least one triangle");
      return;
    }
    if (mesh->triangles.size() > kMostObjectTriangles) {
      refuse("a mesh of " + std::to_string(mesh->triangles.size()) + " triangles",
             "at most " + std::to_string(kMostObjectTriangles));
      return;
    }
    try {
      checkMesh(*mesh, kFarthestObject);
    } catch (const std::invalid_argument& fault) {
      refuse(fault.what(), "");
    }
  }
};

}  // namespace

bool checkPlacing(const Pose& pose, const std::string& where, SetupReport& report) {
  const std::size_t before = report.errors.size();
  if (!(pose.translation.array().abs() <= kFarthestObject).all()) {
    report.errors.push_back({where, "position " + textOf(pose.translation),
                             "finite numbers up to " + shortText(kFarthestObject) + " m"});
  } else if (!isRigid(pose)) {
    report.errors.push_back({where, "an orientation that is no rotation", "a unit quaternion"});
  }
  return report.errors.size() == before;
}

bool checkObject(const WorldObject& object, const std::string& where, SetupReport& report) {
  const std::size_t before = report.errors.size();
  checkPlacing(object.frame_from_object, where, report);
  if (!object.lacks_shapes && (!object.shapes || object.shapes->empty())) {
    report.errors.push_back({where, "no shapes", "at least one shape"});
  }
  for (std::size_t i = 0; object.shapes && i < object.shapes->size(); ++i) {
    const std::string shape = where + ", shape " + std::to_string(i + 1);
    checkPlacing((*object.shapes)[i].object_from_shape, shape, report);
    std::visit(GeometryCheck{shape, report}, (*object.shapes)[i].geometry);
  }
  if (!(object.padding >= 0.0 && object.padding <= kMostObjectPadding)) {
    report.errors.push_back({where, "padding " + shortText(object.padding) + " m",
                             "from 0 to " + shortText(kMostObjectPadding) + " m"});
  }
  for (const float part : object.colour) {
    if (!(part >= 0.0F && part <= 1.0F)) {
      report.errors.push_back(
          {where, "colour with " + shortText(static_cast<double>(part)), "numbers from 0 to 1"});
      break;
    }
  }
  return report.errors.size() == before;
}

}  // namespace collision_monitor
