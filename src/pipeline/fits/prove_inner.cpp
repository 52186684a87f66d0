// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/fits/prove_inner.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "fitting/proofs/check_geometry.h"
#include "fitting/proofs/segment_clearance.h"
#include "narrow_phase/mesh_inside/mesh_inside.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

struct InnerBall {
  Vector3d center;
  double radius;
};

/// Whether the box of a child is certainly outside the ball. @param ball in the frame of nodes
bool isBeyond(const MeshTreeNode& node, std::size_t slot, const InnerBall& ball) {
  Vector3d gap;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double travel = std::abs(ball.center[axis] - static_cast<double>(node.center[k][slot]));
    gap[axis] = std::max(0.0, travel - static_cast<double>(node.half[k][slot]));
  }
  return gap.squaredNorm() > ball.radius * ball.radius;
}

/// Calls is_clear(triangle) for each triangle that may be within the ball, until it is false.
template <class IsClear>
bool allClear(const MeshTree& tree, const InnerBall& ball, const IsClear& is_clear) {
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const MeshTreeNode& node = tree.nodes()[open.back()];
    open.pop_back();
    for (std::size_t slot = 0; slot < MeshTreeNode::kWidth; ++slot) {
      const std::uint32_t child = node.child[slot];
      if (child == kNone || isBeyond(node, slot, ball)) {
        continue;
      }
      if ((child & MeshTreeNode::kTriangle) == 0) {
        open.push_back(child);
      } else if (!is_clear(tree.triangles()[child & ~MeshTreeNode::kTriangle])) {
        return false;
      }
    }
  }
  return true;
}

/// Tests the core in pieces, each with a ball around what must be clear.
bool isClear(const MeshTree& tree, const Vector3d& a, const Vector3d& b, double radius) {
  constexpr double kMostPieces = 64.0;
  constexpr double kRounding = 1e-12;
  const double slack = kRounding * (tree.radius() + tree.center().norm() + radius);
  const double pieces = std::clamp(std::ceil((b - a).norm() / radius), 1.0, kMostPieces);
  Vector3d from = a;
  for (double i = 1.0; i <= pieces; ++i) {
    const Vector3d to = i == pieces ? b : Vector3d(a + i / pieces * (b - a));
    const InnerBall ball{0.5 * (from + to) - tree.center(),
                         radius + 0.5 * (to - from).norm() + slack};
    const auto is_far = [&](const Triangle& triangle) {
      return clearanceBound(triangle, from, to, radius) >= radius;
    };
    if (!allClear(tree, ball, is_far)) {
      return false;
    }
    from = to;
  }
  return true;
}

bool isInsideOf(const MeshTree& tree, const PosedShape& shape, double half_length, double radius) {
  const Pose& pose = shape.geometry_from_body;
  if (!isRigid(pose) || !std::isfinite(half_length) || !(half_length >= 0.0) ||
      !std::isfinite(radius) || !(radius > 0.0)) {
    return false;
  }
  const Vector3d half = pose.rotation.col(2) * half_length;
  const Vector3d a = pose.translation - half;
  const auto memory = std::make_unique<MeshQueryMemory>();
  return isInside(tree, a, *memory) && isClear(tree, a, pose.translation + half, radius);
}

}  // namespace

bool areInside(const InnerShapes& inner, const MeshTree& tree) {
  if (!inner.sphere && !inner.capsule) {
    return true;
  }
  if (!tree.isClosed()) {
    return false;
  }
  if (inner.sphere) {
    const auto* sphere = std::get_if<Sphere>(&inner.sphere->shape);
    if (sphere == nullptr || !isInsideOf(tree, *inner.sphere, 0.0, sphere->radius)) {
      return false;
    }
  }
  if (inner.capsule) {
    const auto* capsule = std::get_if<Capsule>(&inner.capsule->shape);
    return capsule != nullptr &&
           isInsideOf(tree, *inner.capsule, capsule->half_length, capsule->radius);
  }
  return true;
}

}  // namespace collision_monitor
