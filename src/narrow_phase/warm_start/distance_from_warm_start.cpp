// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/warm_start/distance_from_warm_start.h"

#include <array>
#include <cmath>

#include "narrow_phase/gjk/simplex.h"
#include "narrow_phase/warm_start/cylinder_from_warm_start.h"
#include "narrow_phase/warm_start/depth_from_warm_start.h"

namespace collision_monitor {
namespace {

constexpr int kMaxSteps = 6;

// The corners that are followed, as many as `warm` has.
struct Followed {
  explicit Followed(ConvexWarmStart& warm_start) noexcept : warm(warm_start) {}

  ConvexWarmStart& warm;
  std::array<Eigen::Vector3d, 4> on_a;
  std::array<Eigen::Vector3d, 4> differences;
};

void place(std::size_t i, const PlacedPair& pair, Followed& followed) noexcept {
  const PlacedCorners placed = place(followed.warm.ends[i], pair);
  followed.on_a[i] = placed.on_a;
  followed.differences[i] = placed.difference;
}

// Corners ascend, so none is overwritten before it is read.
void keep(const NearestOnSimplex& nearest, Followed& followed) noexcept {
  followed.warm.size = static_cast<std::uint32_t>(nearest.size);
  for (std::size_t i = 0; i < followed.warm.size; ++i) {
    const auto from = static_cast<std::size_t>(nearest.corners[i]);
    if (from != i) {
      followed.warm.ends[i] = followed.warm.ends[from];
      followed.on_a[i] = followed.on_a[from];
      followed.differences[i] = followed.differences[from];
    }
  }
}

// Does steps of GJK, without what only a long search needs.
bool stepToNearest(const PlacedPair& pair, Followed& followed, NearestOnSimplex& nearest,
                   Eigen::Vector3d& normal, bool& is_level) noexcept {
  for (int step = 0; step < kMaxSteps; ++step) {
    normal = normalOf(nearest);
    const double distance = normal.dot(nearest.point);
    if (!(distance > touchingDistance(pair.size))) {
      return false;
    }
    const SupportPlanes planes = supportPlanes(pair, normal);
    if (meet(planes, distance, roundingOf(pair.size))) {
      is_level = planes.may_be_level && areLevel(pair, planes);
      return true;
    }
    const std::uint32_t newest = followed.warm.size;
    followed.warm.ends[newest] = cornersOf(pair, planes);
    place(newest, pair, followed);
    const NearestOnSimplex next = nearestWith(followed.differences, static_cast<int>(newest));
    if (!(next.squared < nearest.squared) || normal.dot(followed.differences[newest]) <= 0.0) {
      return false;
    }
    nearest = next;
    keep(nearest, followed);
  }
  return false;
}

std::optional<WarmStartDistance> cornersFromWarmStart(const PlacedPair& pair,
                                                      ConvexWarmStart& warm) noexcept {
  Followed followed(warm);
  for (std::size_t i = 0; i < warm.size; ++i) {
    place(i, pair, followed);
  }
  const int count = static_cast<int>(warm.size);
  NearestOnSimplex nearest;
  if (!nearestOfSimplex(followed.differences, count, nearest)) {
    nearest = nearestOfAll(followed.differences, count);
    if (nearest.size == 0) {
      return std::nullopt;  // not finite
    }
    keep(nearest, followed);
  }
  Eigen::Vector3d normal;
  bool is_level = false;
  if (!stepToNearest(pair, followed, nearest, normal, is_level)) {
    return std::nullopt;
  }
  const double distance = normal.dot(nearest.point);
  Eigen::Vector3d on_a = pair.a.world_from_core.translation;
  for (std::size_t i = 0; i < warm.size; ++i) {
    on_a += nearest.weights[i] * followed.on_a[i];
  }
  return WarmStartDistance{{distance, on_a, on_a + distance * normal, normal}, is_level};
}

}  // namespace

std::optional<WarmStartDistance> distanceFromWarmStart(const PlacedCore& a, const PlacedCore& b,
                                                       ConvexWarmStart& warm) noexcept {
  if (isSmooth(a.core) || isSmooth(b.core)) {
    return cylinderFromWarmStart(a, b, warm);
  }
  if (warm.size == 0 || warm.size > 3) {
    return std::nullopt;
  }
  const PlacedPair pair = makePlacedPair(a, b);
  return warm.polytope_faces > 0 ? depthFromWarmStart(pair, warm)
                                 : cornersFromWarmStart(pair, warm);
}

}  // namespace collision_monitor
