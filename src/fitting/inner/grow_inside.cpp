// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/inner/grow_inside.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/proofs/near_triangles.h"
#include "fitting/search/point_cloud.h"
#include "fitting/search/simplex_search.h"
#include "geometry/constants.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr double kCoarse = 0.1;  // relative tolerance of distances, at first and for segments
constexpr double kFine = 0.02;
constexpr double kReach = 0.8;  // of a ball known to be empty; less than 1 / (1 + kCoarse)
constexpr double kGain = 1e-4;  // a round with less gain and no new triangle is idle
constexpr int kRounds = 12;
constexpr int kIdleRounds = 2;  // this many in a row end the search

/// A simplex degenerates in a crease. So each round starts a new one, in alternating directions and
/// with several sizes.
double firstStep(int round) {
  constexpr double kSteps[] = {0.3, -0.3, 0.1, -0.1};
  return kSteps[round % 4];
}

/// Samples a ball around a point. Queries are cheaper away from the middle of a body.
void lookAround(const Vector3d& point, double radius, NearTriangles& near) {
  constexpr int kDirections = 20;
  for (const auto& direction : spreadDirections(kDirections)) {
    near.nearestOfAll(point + 0.5 * radius * direction, kCoarse);
  }
}

/// Searches in rounds among the known triangles. A query of all triangles follows each round.
void growBall(double tolerance, NearTriangles& near, EmptyBall& ball) {
  for (int round = 0, idle = 0; round < kRounds && idle < kIdleRounds; ++round) {
    const EmptyBall start = ball;
    const auto cost = [&](const Vector3d& step) {
      return step.norm() < kReach
                 ? -near.nearestKnown(start.center + start.radius * step).distance / start.radius
                 : 0.0;
    };
    const Vector3d step = searchSimplex<3>({firstStep(round), 1e-6, 120}, cost);
    const Vector3d center = start.center + start.radius * step;
    const double hoped = near.nearestKnown(center).distance;
    const double found = near.nearestOfAll(center, tolerance).distance;
    if (found > start.radius) {
      ball = {center, found};
    }
    idle = found >= hoped && found <= start.radius * (1.0 + kGain) ? idle + 1 : 0;
  }
}

/// The segment with its distance to the known triangles.
InnerSegment amongKnown(const NearTriangles& near, const Vector3d& a, const Vector3d& b) {
  constexpr int kSamples = 4;
  InnerSegment segment{a, b, std::numeric_limits<double>::infinity()};
  for (int i = 0; i <= kSamples; ++i) {
    const Vector3d point = a + i * 1.0 / kSamples * (b - a);
    segment.radius = std::min(segment.radius, near.nearestKnown(point).distance);
  }
  return segment;
}

InnerSegment amongAll(NearTriangles& near, const Vector3d& a, const Vector3d& b,
                      double least_radius) {
  constexpr double kSteps = 8.0;
  InnerSegment segment{a, b, std::numeric_limits<double>::infinity()};
  const double length = (b - a).norm();
  double place = 0.0;
  for (bool is_end = false; !is_end;) {
    is_end = place >= length;
    const Vector3d point = is_end ? b : Vector3d(a + place / length * (b - a));
    const double distance = near.nearestOfAll(point, kCoarse).distance;
    segment.radius = std::min(segment.radius, distance);
    if (!(distance > least_radius)) {
      segment.radius = 0.0;
      return segment;
    }
    place += std::min(kReach * distance, length / kSteps);
  }
  return segment;
}

}  // namespace

double volumeOf(const InnerSegment& segment) {
  const double r = segment.radius;
  return kPi * r * r * ((segment.b - segment.a).norm() + 4.0 / 3.0 * r);
}

InnerSegment innerSegment(const TriangleBvh& surface, const Vector3d& a, const Vector3d& b,
                          double least_radius) {
  NearTriangles near(surface);
  return amongAll(near, a, b, least_radius);
}

EmptyBall growBall(const TriangleBvh& surface, const EmptyBall& ball) {
  NearTriangles near(surface);
  lookAround(ball.center, ball.radius, near);
  EmptyBall grown{ball.center, near.nearestOfAll(ball.center, kCoarse).distance};
  growBall(kCoarse, near, grown);
  grown.radius = near.nearestOfAll(grown.center, kFine).distance;
  growBall(kFine, near, grown);
  return grown;
}

InnerSegment growSegment(const TriangleBvh& surface, const InnerSegment& segment) {
  using Step = Eigen::Matrix<double, 6, 1>;
  constexpr double kWorse = 0.5;  // of the radius: segments below this share are not measured
  NearTriangles near(surface);
  InnerSegment best = segment;
  for (const double place : {0.0, 0.5, 1.0}) {
    lookAround(best.a + place * (best.b - best.a), best.radius, near);
  }
  for (int round = 0, idle = 0; round < kRounds && idle < kIdleRounds; ++round) {
    throwIfInterrupted();
    const InnerSegment start = best;
    const auto moved = [&](const Step& step) -> std::pair<Vector3d, Vector3d> {
      return {start.a + start.radius * step.head<3>(), start.b + start.radius * step.tail<3>()};
    };
    const auto cost = [&](const Step& step) {
      const auto [a, b] = moved(step);
      const bool is_known = step.head<3>().norm() < kReach && step.tail<3>().norm() < 2.0;
      return is_known ? -volumeOf(amongKnown(near, a, b)) / volumeOf(start) : 0.0;
    };
    const auto [a, b] = moved(searchSimplex<6>({firstStep(round), 1e-5, 200}, cost));
    const double hoped = volumeOf(amongKnown(near, a, b));
    const InnerSegment found = amongAll(near, a, b, kWorse * start.radius);
    const double volume = volumeOf(found);
    best = volume > volumeOf(start) ? found : start;
    const bool is_idle = volume >= 0.99 * hoped && volume <= volumeOf(start) * (1.0 + 10.0 * kGain);
    idle = is_idle ? idle + 1 : 0;
  }
  return best;
}

}  // namespace collision_monitor
