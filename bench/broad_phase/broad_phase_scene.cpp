// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase_scene.h"

#include <cmath>

namespace collision_monitor::bench {
namespace {

constexpr double kStep = 0.01;
constexpr double kCrowdSide = 4.0;
constexpr double kBeamLength = 30.0;

/// Pairs per body: N (mean of the sum of two edges)^3 / (2 side^3).
double sideFor(std::size_t count) {
  constexpr double kPairsABody = 1.3;
  return std::cbrt(static_cast<double>(count) * 8.0 / (2.0 * kPairsABody));
}

Eigen::Vector3d randomEdges(SceneKind kind, test::Random& random) {
  if (kind == SceneKind::beams) {
    Eigen::Vector3d edges = Eigen::Vector3d::Constant(0.2);
    edges[static_cast<Eigen::Index>(random() % 3)] = kBeamLength;
    return edges;
  }
  return test::randomPoint(random, 0.5) + Eigen::Vector3d::Ones();
}

}  // namespace

const char* nameOf(SceneKind kind) noexcept {
  constexpr const char* kNames[] = {"coherent", "random", "clustered", "beams"};
  return kNames[static_cast<std::size_t>(kind)];
}

BoxScene::BoxScene(SceneKind kind, std::size_t count)
    : kind_(kind), side_(sideFor(count)), random_(20260101) {
  bounds_.boxes.resize(count);
  bounds_.known.resize(count, 1);
  for (std::size_t body = 0; body < count; ++body) {
    half_edges_.push_back(0.5 * randomEdges(kind, random_));
    velocities_.push_back(kStep * test::randomPoint(random_, 1.0).normalized());
    place(body);
  }
}

void BoxScene::place(std::size_t body) {
  Eigen::Vector3d center = test::randomPoint(random_, 0.5 * side_);
  if (kind_ == SceneKind::clustered && body % 2 == 0) {
    test::Random of_crowd(body / 200);
    center =
        test::randomPoint(of_crowd, 0.5 * side_) + test::randomPoint(random_, 0.5 * kCrowdSide);
  }
  bounds_.boxes[body] = {center - half_edges_[body], center + half_edges_[body]};
}

void BoxScene::advance() {
  for (std::size_t body = 0; body < bounds_.boxes.size(); ++body) {
    if (kind_ == SceneKind::random) {
      place(body);
      continue;
    }
    Aabb& box = bounds_.boxes[body];
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (std::abs(box.min[axis] + half_edges_[body][axis]) > 0.5 * side_) {
        const bool is_above = box.min[axis] > 0.0;
        velocities_[body][axis] = std::copysign(velocities_[body][axis], is_above ? -1.0 : 1.0);
      }
    }
    box.min += velocities_[body];
    box.max += velocities_[body];
  }
}

}  // namespace collision_monitor::bench
