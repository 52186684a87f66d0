// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/confirm_nearest.h"

#include <array>
#include <cmath>

#include "narrow_phase/confirm_cylinder.h"
#include "narrow_phase/confirm_depth.h"
#include "narrow_phase/simplex.h"

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

// Corners ascend, so that none is overwritten before its turn.
void keep(const NearestPoint& nearest, Followed& followed) noexcept {
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

// Steps of GJK without what only a long search needs.
bool stepToNearest(const PlacedPair& pair, Followed& followed, NearestPoint& nearest,
                   Eigen::Vector3d& normal) noexcept {
  for (int step = 0; step < kMaxSteps; ++step) {
    keep(nearest, followed);
    const double distance = std::sqrt(nearest.squared);
    normal = normalOf(nearest);
    if (!(distance > touchingDistance(pair.size))) {
      return false;
    }
    if (isProven(pair, normal, distance, roundingOf(pair.size))) {
      return true;
    }
    const std::uint32_t newest = followed.warm.size;
    followed.warm.ends[newest] = supportEnds(pair, normal);
    place(newest, pair, followed);
    const NearestPoint next = nearestWith(followed.differences, static_cast<int>(newest));
    if (!(next.squared < nearest.squared) || normal.dot(followed.differences[newest]) <= 0.0) {
      return false;
    }
    nearest = next;
  }
  return false;
}

bool confirmCorners(const PlacedPair& pair, ConvexWarmStart& warm, SignedDistance& cores) noexcept {
  Followed followed(warm);
  for (std::size_t i = 0; i < warm.size; ++i) {
    place(i, pair, followed);
  }
  const int count = static_cast<int>(warm.size);
  NearestPoint nearest;
  if (!nearestInside(followed.differences, count, nearest)) {
    nearest = nearestOfAll(followed.differences, count);
  }
  if (nearest.size == 0) {
    return false;  // not finite
  }
  Eigen::Vector3d normal;
  if (!stepToNearest(pair, followed, nearest, normal)) {
    return false;
  }
  cores.distance = std::sqrt(nearest.squared);
  cores.normal_a_to_b = normal;
  cores.point_on_a = pair.a.world_from_core.translation;
  for (std::size_t i = 0; i < warm.size; ++i) {
    cores.point_on_a += nearest.weights[i] * followed.on_a[i];
  }
  cores.point_on_b = cores.point_on_a + cores.distance * normal;
  return true;
}

}  // namespace

bool confirmNearest(const PlacedCore& a, const PlacedCore& b, ConvexWarmStart& warm,
                    SignedDistance& cores) noexcept {
  if (warm.size == 0 || warm.size > 3) {
    return false;
  }
  if (isSmooth(a.core) || isSmooth(b.core)) {
    return confirmCylinder(a, b, warm, cores);
  }
  const PlacedPair pair = makePlacedPair(a, b);
  return warm.inside.face_count > 0 ? confirmDepth(pair, warm, cores)
                                    : confirmCorners(pair, warm, cores);
}

}  // namespace collision_monitor
