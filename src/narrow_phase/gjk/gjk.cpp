// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/gjk/gjk.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "narrow_phase/closed_form/core_distance.h"

namespace collision_monitor {
namespace {

constexpr int kMaxSteps = 128;

void seed(ConvexPair& pair, const ConvexWarmStart& warm, Simplex& simplex) noexcept {
  for (std::size_t i = 0; i < warm.size; ++i) {
    simplex.vertices[i] = differenceOf(pair, warm.ends[i].on_a, warm.ends[i].on_b);
  }
  if (spanAll(static_cast<int>(warm.size), simplex)) {
    return;
  }
  const std::array<SupportVertex, 4> last = simplex.vertices;
  for (std::size_t i = 0; i < warm.size && !simplex.contains_origin; ++i) {
    insert(last[i], simplex);
  }
  if (simplex.size == 0) {
    insert(leastAlong(pair.a_from_b.translation, pair), simplex);
  }
}

SupportVertex measureGap(const Eigen::Vector3d& direction, ConvexPair& pair,
                         GjkResult& result) noexcept {
  SupportVertex least = leastAlong(direction, pair);
  const double gap = direction.dot(least.difference);
  if (gap > result.lower) {
    result.lower = gap;
    result.lower_direction = direction;
  }
  return least;
}

// If the nearest point is almost the origin, its direction is mostly rounding. The faces that it
// forms with the last vertex have sharp normals, one of which is as good.
void tryFaceNormals(const SupportVertex& vertex, ConvexPair& pair, GjkResult& result) noexcept {
  const Eigen::Vector3d& apex = vertex.difference;
  const auto size = static_cast<std::size_t>(result.simplex.size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::Vector3d normal = (result.simplex.vertices[i].difference - apex)
                                         .cross(result.simplex.vertices[j].difference - apex);
      const double length = normal.norm();
      if (length > 0.0) {
        measureGap(signOf(normal.dot(result.simplex.nearest)) / length * normal, pair, result);
      }
    }
  }
}

bool hasMet(const ConvexPair& pair, const GjkResult& result) noexcept {
  return result.simplex.distance - result.lower <= toleranceOf(pair);
}

GjkResult::State walk(ConvexPair& pair, const GjkLimits& limits, GjkResult& result) noexcept {
  using State = GjkResult::State;
  const double touching = touchingDistance(pair);
  Simplex& simplex = result.simplex;
  const int last = std::min(kMaxSteps, limits.steps);
  for (; result.steps < last; ++result.steps) {
    if (simplex.contains_origin || simplex.distance <= touching) {
      return State::overlapping;
    }
    const SupportVertex next = measureGap(simplex.normal, pair, result);
    result.gap = simplex.normal.dot(next.difference);
    if (hasMet(pair, result)) {
      return State::settled;
    }
    if (result.lower >= limits.cutoff) {
      return State::stopped;
    }
    if (simplex.distance < limits.near) {
      return State::near;
    }
    bool is_nearer = insert(next, simplex);
    if (simplex.contains_origin && result.lower > touching) {
      // A plane has proven that the cores are apart: the tetrahedron is a sliver.
      simplex.contains_origin = false;
      simplex.size = 3;
      is_nearer = false;
    }
    if (!is_nearer) {
      tryFaceNormals(next, pair, result);
      return hasMet(pair, result) ? State::settled : State::stalled;
    }
  }
  return result.steps < kMaxSteps ? State::paused : State::stalled;
}

}  // namespace

GjkResult runGjk(ConvexPair& pair, const ConvexWarmStart& warm, const GjkLimits& limits) noexcept {
  GjkResult result;
  pair.vertex_of_a = warm.vertex_of_a;
  pair.vertex_of_b = warm.vertex_of_b;
  seed(pair, warm, result.simplex);
  resumeGjk(pair, limits, result);
  return result;
}

GjkResult runGjk(ConvexPair& pair, const Eigen::Vector3d& direction,
                 const GjkLimits& limits) noexcept {
  GjkResult result;
  insert(leastAlong(direction, pair), result.simplex);
  resumeGjk(pair, limits, result);
  return result;
}

void resumeGjk(ConvexPair& pair, const GjkLimits& limits, GjkResult& result) noexcept {
  result.state = walk(pair, limits, result);
}

void keepWarm(const SupportVertex* vertices, int count, const ConvexPair& pair,
              ConvexWarmStart& warm) noexcept {
  warm.size = static_cast<std::uint32_t>(count);
  for (std::size_t i = 0; i < warm.size; ++i) {
    warm.ends[i] = {vertices[i].on_a, vertices[i].on_b};
  }
  warm.vertex_of_a = pair.vertex_of_a;
  warm.vertex_of_b = pair.vertex_of_b;
}

}  // namespace collision_monitor
