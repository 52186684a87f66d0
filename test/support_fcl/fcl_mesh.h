// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <memory>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/triangle_mesh.h"

/// Meshes for the flexible collision library, with the bounds that it is fastest with.
namespace collision_monitor::test {

using FclMesh = fcl::BVHModel<fcl::OBBRSSd>;

inline std::shared_ptr<FclMesh> toFcl(const TriangleMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& corners : mesh.triangles) {
    triangles.emplace_back(corners[0], corners[1], corners[2]);
  }
  auto model = std::make_shared<FclMesh>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
  model->addSubModel(mesh.vertices, triangles);
  model->endModel();
  return model;
}

inline fcl::CollisionObjectd fclObject(const std::shared_ptr<FclMesh>& mesh, const Pose& pose) {
  return {mesh, pose.rotation, pose.translation};
}

/// 0 or less when surfaces cross.
inline double fclMeshDistance(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b) {
  const fcl::DistanceRequestd request(true);
  fcl::DistanceResultd result;
  fcl::distance(&a, &b, request, result);
  return result.min_distance;
}

inline bool fclMeshOverlap(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b) {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(&a, &b, request, result) > 0;
}

}  // namespace collision_monitor::test
