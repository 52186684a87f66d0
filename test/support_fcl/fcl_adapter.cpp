// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support_fcl/fcl_adapter.h"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <exception>
#include <vector>

#include "geometry/hulls/convex_hull.h"

namespace collision_monitor::test {
namespace {

struct ToGeometry {
  FclGeometry operator()(const Sphere& shape) const {
    return std::make_shared<fcl::Sphered>(shape.radius);
  }
  FclGeometry operator()(const Capsule& shape) const {
    return std::make_shared<fcl::Capsuled>(shape.radius, 2.0 * shape.half_length);
  }
  FclGeometry operator()(const Box& shape) const {
    return std::make_shared<fcl::Boxd>(2.0 * shape.half_extents);
  }
  FclGeometry operator()(const RoundedBox& shape) const {
    return shape.radius > 0.0 ? nullptr : (*this)(Box{shape.half_extents});
  }
  FclGeometry operator()(const Cylinder& shape) const {
    return std::make_shared<fcl::Cylinderd>(shape.radius, 2.0 * shape.half_length);
  }
  FclGeometry operator()(const ConvexHull& hull) const {
    const TriangleMesh mesh = convexHullOf(hull.vertices());
    auto faces = std::make_shared<std::vector<int>>();
    for (const auto& triangle : mesh.triangles) {
      faces->push_back(3);
      faces->insert(faces->end(), triangle.begin(), triangle.end());
    }
    return std::make_shared<fcl::Convexd>(
        std::make_shared<const std::vector<Eigen::Vector3d>>(mesh.vertices),
        static_cast<int>(mesh.triangles.size()), faces);
  }
  FclGeometry operator()(const HalfSpace&) const { return nullptr; }
};

std::optional<double> distanceBy(const fcl::DistanceRequestd& request, const FclObject& a,
                                 const FclObject& b) {
  try {
    fcl::DistanceResultd result;
    fcl::distance(&a, &b, request, result);
    return result.min_distance;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace

FclGeometry toFclGeometry(const ConvexGeometry& geometry) {
  return std::visit(ToGeometry{}, geometry);
}

std::optional<FclObject> toFcl(const Shape& shape, const Pose& world_from_shape) {
  const FclGeometry geometry = std::visit(ToGeometry{}, shape);
  if (geometry == nullptr) {
    return std::nullopt;
  }
  return FclObject(geometry, world_from_shape.rotation, world_from_shape.translation);
}

std::optional<double> fclDistance(const FclObject& a, const FclObject& b) {
  return distanceBy(fcl::DistanceRequestd(false, false), a, b);
}

std::optional<double> fclSignedDistance(const FclObject& a, const FclObject& b) {
  return distanceBy(fcl::DistanceRequestd(true, true), a, b);
}

std::optional<bool> fclOverlap(const FclObject& a, const FclObject& b) {
  try {
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    return fcl::collide(&a, &b, request, result) > 0;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::optional<double> fclDepth(const FclObject& a, const FclObject& b) {
  try {
    constexpr std::size_t kManyContacts = 16;
    const fcl::CollisionRequestd request(kManyContacts, true);
    fcl::CollisionResultd result;
    fcl::collide(&a, &b, request, result);
    std::vector<fcl::Contactd> contacts;
    result.getContacts(contacts);
    if (contacts.empty()) {
      return std::nullopt;
    }
    double depth = 0.0;
    for (const fcl::Contactd& contact : contacts) {
      depth = std::max(depth, contact.penetration_depth);
    }
    return depth;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace collision_monitor::test
