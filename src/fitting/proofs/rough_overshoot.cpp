// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/rough_overshoot.h"

#include <cmath>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kSteps = 5;  // along an edge of the core

struct PatternPoint {
  Vector3f fraction;
  Vector3f outward;
  double share{0.0};
};

void add(const PatternPoint& point, PatternPatch& patch) {
  const std::size_t place = patch.rows.count++;
  for (std::size_t k = 0; k < 3; ++k) {
    patch.rows.fraction[k][place] = point.fraction[static_cast<Eigen::Index>(k)];
    patch.rows.outward[k][place] = point.outward[static_cast<Eigen::Index>(k)];
  }
  patch.share[place] = point.share;
}

float stepOf(int i) { return 2.0f * static_cast<float>(i) / kSteps - 1.0f; }
double shareOf(int i) { return (i == 0 || i == kSteps ? 0.5 : 1.0) / kSteps; }

void addFaces(int k, SurfacePattern& pattern) {
  for (const float side : {-1.0f, 1.0f}) {
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        PatternPoint point{Vector3f::Zero(), side * Vector3f::Unit(k), shareOf(i) * shareOf(j)};
        point.fraction[k] = side;
        point.fraction[(k + 1) % 3] = stepOf(i);
        point.fraction[(k + 2) % 3] = stepOf(j);
        add(point, pattern[static_cast<std::size_t>(k)]);
      }
    }
  }
}

void addEdges(int k, SurfacePattern& pattern) {
  constexpr int kAngles = 3;
  for (int signs = 0; signs < 4; ++signs) {
    Vector3f side = Vector3f::Zero();
    side[(k + 1) % 3] = (signs & 1) != 0 ? 1.0f : -1.0f;
    side[(k + 2) % 3] = (signs & 2) != 0 ? 1.0f : -1.0f;
    for (int angle = 0; angle < kAngles; ++angle) {
      const double azimuth = kHalfPi * (angle + 0.5) / kAngles;
      Vector3f outward = side;
      outward[(k + 1) % 3] *= static_cast<float>(std::cos(azimuth));
      outward[(k + 2) % 3] *= static_cast<float>(std::sin(azimuth));
      for (int i = 0; i <= kSteps; ++i) {
        PatternPoint point{side, outward, shareOf(i) / kAngles};
        point.fraction[k] = stepOf(i);
        add(point, pattern[3 + static_cast<std::size_t>(k)]);
      }
    }
  }
}

void addCorners(SurfacePattern& pattern) {
  for (int signs = 0; signs < 8; ++signs) {
    const Vector3f side((signs & 1) != 0 ? 1.0f : -1.0f, (signs & 2) != 0 ? 1.0f : -1.0f,
                        (signs & 4) != 0 ? 1.0f : -1.0f);
    for (const auto& inward :
         {Vector3f(1, 1, 1), Vector3f(1, .3f, .3f), Vector3f(.3f, 1, .3f), Vector3f(.3f, .3f, 1),
          Vector3f(1, 1, .3f), Vector3f(1, .3f, 1), Vector3f(.3f, 1, 1)}) {
      add({side, side.cwiseProduct(inward).normalized(), 1.0 / 7.0}, pattern[6]);
    }
  }
}

SurfacePattern makePattern() {
  SurfacePattern pattern;
  for (int k = 0; k < 3; ++k) {
    addFaces(k, pattern);
    addEdges(k, pattern);
  }
  addCorners(pattern);
  return pattern;
}

}  // namespace

const SurfacePattern& surfacePattern() {
  static const SurfacePattern pattern = makePattern();
  return pattern;
}

PatternFrame patternInGrid(const TurnedCore& core, const DistanceGrid& grid) noexcept {
  const DistanceGrid::Place center = grid.inGrid(core.center);
  const Eigen::Matrix3d in_grid = grid.nodesPerMetre() * core.rotation;
  const Eigen::Matrix3f of_fraction = (in_grid * core.half_extents.asDiagonal()).cast<float>();
  const Eigen::Matrix3f of_outward = (core.radius * in_grid).cast<float>();
  PatternFrame frame{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto row = static_cast<Eigen::Index>(axis);
    frame.center[axis] = center[row];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      frame.of_fraction[k][axis] = of_fraction(row, column);
      frame.of_outward[k][axis] = of_outward(row, column);
    }
  }
  return frame;
}

std::array<double, 7> patchAreas(const TurnedCore& core) noexcept {
  const Vector3d& h = core.half_extents;
  const double r = core.radius;
  return {4 * h.y() * h.z(),       4 * h.z() * h.x(),       4 * h.x() * h.y(),
          2 * kHalfPi * r * h.x(), 2 * kHalfPi * r * h.y(), 2 * kHalfPi * r * h.z(),
          kHalfPi * r * r};
}

}  // namespace collision_monitor
