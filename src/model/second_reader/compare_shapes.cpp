// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "model/place.h"
#include "model/second_reader/compare_readings.h"

namespace collision_monitor {
namespace {

/// A shape by its kind and numbers [m]; a mesh by its name and scale.
struct ShapeReading {
  std::string kind;
  Eigen::Vector3d numbers;
  std::string mesh;
};

ShapeReading readingOf(const CollisionElement& element) {
  if (const auto* box = std::get_if<Box>(&element.geometry)) {
    return {"box", 2.0 * box->half_extents, ""};
  }
  if (const auto* sphere = std::get_if<Sphere>(&element.geometry)) {
    return {"sphere", {sphere->radius, 0.0, 0.0}, ""};
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&element.geometry)) {
    return {"cylinder", {cylinder->radius, 2.0 * cylinder->half_length, 0.0}, ""};
  }
  return {"mesh", element.mesh_scale, element.mesh_name};
}

ShapeReading readingOf(const urdf::Geometry& geometry) {
  if (const auto* box = dynamic_cast<const urdf::Box*>(&geometry)) {
    return {"box", vectorOf(box->dim), ""};
  }
  if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&geometry)) {
    return {"sphere", {sphere->radius, 0.0, 0.0}, ""};
  }
  if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry)) {
    return {"cylinder", {cylinder->radius, cylinder->length, 0.0}, ""};
  }
  if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(&geometry)) {
    return {"mesh", vectorOf(mesh->scale), mesh->filename};
  }
  return {"a shape of another kind", Eigen::Vector3d::Zero(), ""};
}

bool areAlike(const ShapeReading& ours, const ShapeReading& theirs) {
  return ours.kind == theirs.kind && ours.mesh == plainText(theirs.mesh) &&
         areSame(ours.numbers.x(), theirs.numbers.x()) &&
         areSame(ours.numbers.y(), theirs.numbers.y()) &&
         areSame(ours.numbers.z(), theirs.numbers.z());
}

std::string textOf(const ShapeReading& shape) {
  if (shape.kind == "sphere") {
    return "sphere of radius " + numberText(shape.numbers.x());
  }
  if (shape.kind == "cylinder") {
    return "cylinder of radius " + numberText(shape.numbers.x()) + " and length " +
           numberText(shape.numbers.y());
  }
  return shape.kind + (shape.mesh.empty() ? " " : " " + quoted(shape.mesh) + " of scale ") +
         vectorText(shape.numbers);
}

bool isCapsule(const CollisionElement& element) {
  return std::holds_alternative<Capsule>(element.geometry);
}

bool areAlike(const CollisionElement& ours, const urdf::Collision& theirs) {
  return theirs.geometry && areAlike(readingOf(ours), readingOf(*theirs.geometry)) &&
         areSame(ours.link_from_geometry, theirs.origin);
}

std::string placedText(const std::string& shape, const Pose& pose) {
  return shape + " at " + poseText(pose);
}

void compareInOrder(const std::string& element, const std::vector<CollisionElement>& ours,
                    const std::vector<urdf::CollisionSharedPtr>& theirs, Differences& differences) {
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (!areAlike(ours[i], *theirs[i])) {
      differences.add(element + ", collision " + quoted(ours[i].name),
                      placedText(textOf(readingOf(ours[i])), ours[i].link_from_geometry),
                      theirs[i]->geometry ? placedText(textOf(readingOf(*theirs[i]->geometry)),
                                                       poseOf(theirs[i]->origin))
                                          : "no shape");
    }
  }
}

/// How many of our shapes urdfdom may have. It does not know `<capsule>` and stops reading the
/// link's shapes there. A capsule merged from a cylinder and spheres is three shapes for urdfdom,
/// or fewer if it shares a sphere.
std::size_t countKnown(const std::vector<CollisionElement>& ours, std::size_t their_count) {
  constexpr std::size_t kShapesOfCapsule = 3;
  std::size_t most_before = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (isCapsule(ours[i]) && their_count <= most_before) {
      return i;
    }
    most_before += isCapsule(ours[i]) ? kShapesOfCapsule : 1;
  }
  return ours.size();
}

/// urdfdom has no capsules. It must have all our other shapes, in the same order.
void compareBesideCapsules(const std::string& element, const std::vector<CollisionElement>& ours,
                           const std::vector<urdf::CollisionSharedPtr>& theirs,
                           Differences& differences) {
  const std::size_t known = countKnown(ours, theirs.size());
  auto next = theirs.begin();
  for (std::size_t i = 0; i < known; ++i) {
    if (isCapsule(ours[i])) {
      continue;
    }
    const auto found = std::find_if(next, theirs.end(), [&](const urdf::CollisionSharedPtr& other) {
      return areAlike(ours[i], *other);
    });
    if (found == theirs.end()) {
      differences.add(element + ", collision " + quoted(ours[i].name),
                      placedText(textOf(readingOf(ours[i])), ours[i].link_from_geometry),
                      "no such shape");
    } else {
      next = found + 1;
    }
  }
}

}  // namespace

void compareShapes(const std::string& element, const std::vector<CollisionElement>& ours,
                   const std::vector<urdf::CollisionSharedPtr>& theirs, Differences& differences) {
  if (std::any_of(ours.begin(), ours.end(), isCapsule)) {
    compareBesideCapsules(element, ours, theirs, differences);
  } else if (ours.size() != theirs.size()) {
    differences.add(element, std::to_string(ours.size()) + " collision shapes",
                    std::to_string(theirs.size()) + " collision shapes");
  } else {
    compareInOrder(element, ours, theirs, differences);
  }
}

}  // namespace collision_monitor
