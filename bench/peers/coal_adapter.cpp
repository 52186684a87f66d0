// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "peers/coal_adapter.h"

#include <coal/collision.h>
#include <coal/distance.h>
#include <coal/shape/convex.h>
#include <coal/shape/geometric_shapes.h>

#include <vector>

#include "geometry/hulls/convex_hull.h"

namespace collision_monitor::test {
namespace {

std::vector<coal::Triangle> trianglesOf(const TriangleMesh& mesh) {
  std::vector<coal::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& corners : mesh.triangles) {
    triangles.emplace_back(corners[0], corners[1], corners[2]);
  }
  return triangles;
}

struct ToGeometry {
  CoalGeometry operator()(const Sphere& shape) const {
    return std::make_shared<coal::Sphere>(shape.radius);
  }
  CoalGeometry operator()(const Capsule& shape) const {
    return std::make_shared<coal::Capsule>(shape.radius, 2.0 * shape.half_length);
  }
  CoalGeometry operator()(const Box& shape) const {
    return std::make_shared<coal::Box>(2.0 * shape.half_extents);
  }
  CoalGeometry operator()(const RoundedBox& shape) const {
    return shape.radius > 0.0 ? nullptr : (*this)(Box{shape.half_extents});
  }
  CoalGeometry operator()(const Cylinder& shape) const {
    return std::make_shared<coal::Cylinder>(shape.radius, 2.0 * shape.half_length);
  }
  CoalGeometry operator()(const ConvexHull& hull) const {
    const TriangleMesh mesh = convexHullOf(hull.vertices());
    const auto faces = std::make_shared<std::vector<coal::Triangle>>(trianglesOf(mesh));
    return std::make_shared<coal::Convex<coal::Triangle>>(
        std::make_shared<std::vector<coal::Vec3s>>(mesh.vertices),
        static_cast<unsigned int>(mesh.vertices.size()), faces,
        static_cast<unsigned int>(faces->size()));
  }
  CoalGeometry operator()(const HalfSpace&) const { return nullptr; }
  CoalGeometry operator()(const TriangleMesh& mesh) const {
    return mesh.triangles.empty() ? nullptr : toCoal(mesh);
  }
};

coal::CollisionRequest overlapRequest() {
  coal::CollisionRequest request(coal::NO_REQUEST, 1);
  request.break_distance = 0.0;        // opens no boxes that are apart
  request.distance_upper_bound = 0.0;  // ends a search that has proven a gap
  return request;
}

}  // namespace

CoalGeometry toCoalGeometry(const ConvexGeometry& geometry) {
  return std::visit(ToGeometry{}, geometry);
}

CoalGeometry coalGeometryOf(const Geometry& geometry) { return std::visit(ToGeometry{}, geometry); }

std::shared_ptr<CoalMesh> toCoal(const TriangleMesh& mesh) {
  auto model = std::make_shared<CoalMesh>();
  model->beginModel(static_cast<unsigned int>(mesh.triangles.size()),
                    static_cast<unsigned int>(mesh.vertices.size()));
  model->addSubModel(mesh.vertices, trianglesOf(mesh));
  model->endModel();
  return model;
}

CoalObject coalObject(const CoalGeometry& geometry, const Pose& world_from_geometry) {
  return {geometry, world_from_geometry.rotation, world_from_geometry.translation};
}

bool coalOverlap(const CoalObject& a, const CoalObject& b) {
  static const coal::CollisionRequest kRequest = overlapRequest();
  coal::CollisionResult result;
  return coal::collide(&a, &b, kRequest, result) > 0;
}

coal::DistanceRequest coalRequest(bool with_depth) { return {true, with_depth}; }

coal::DistanceRequest warmCoalRequest(bool with_depth) {
  coal::DistanceRequest request = coalRequest(with_depth);
  request.gjk_initial_guess = coal::GJKInitialGuess::CachedGuess;
  return request;
}

void lowerByCoal(const CoalObject& a, const CoalObject& b, const coal::DistanceRequest& request,
                 coal::DistanceResult& result) {
  coal::distance(&a, &b, request, result);
}

double coalDistance(const CoalObject& a, const CoalObject& b,
                    const coal::DistanceRequest& request) {
  coal::DistanceResult result;
  lowerByCoal(a, b, request, result);
  return result.min_distance;
}

}  // namespace collision_monitor::test
