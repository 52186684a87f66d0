// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/random_motions.h"

#include <algorithm>
#include <memory>

#include "support/reference/convex_measure.h"

namespace collision_monitor::test {
namespace {

Eigen::Vector3d randomSize(Random& random, double least, double greatest) {
  return {uniform(random, least, greatest), uniform(random, least, greatest),
          uniform(random, least, greatest)};
}

constexpr std::size_t kKinds = 4;

Shape shapeOf(std::size_t kind, const Eigen::Vector3d& size) {
  switch (kind) {
    case 0:
      return Sphere{size.x()};
    case 1:
      return Capsule{size.x(), size.y()};
    case 2:
      return Box{size};
    default:
      return RoundedBox{size, 0.3 * size.x()};
  }
}

ConvexHull randomHull(Random& random) {
  const double size = uniform(random, 0.05, 0.3);
  std::vector<Eigen::Vector3d> points(12);
  for (Eigen::Vector3d& point : points) {
    point = randomPoint(random, size);
  }
  return ConvexHull(points);
}

/// Through the plate z = 0 near the origin: 0.1 m, from 0.03 to 0.07 m above it.
ScrewMotion crossingMotion(Random& random) {
  Pose start{randomRotation(random), randomPoint(random, 0.1)};
  start.translation.z() = uniform(random, 0.03, 0.07);
  const Eigen::Vector3d aside = randomPoint(random, 0.05);
  const Eigen::Vector3d travel = 0.1 * Eigen::Vector3d(aside.x(), aside.y(), -0.1).normalized();
  const Eigen::Vector3d axis = randomPoint(random, 1.0).normalized();
  const Pose turn{Eigen::AngleAxisd(uniform(random, 0.0, 0.5), axis).toRotationMatrix(),
                  Eigen::Vector3d::Zero()};
  Pose end = turn * start;
  end.translation = start.translation + travel;
  return screwBetween(start, end);
}

}  // namespace

Shape randomShape(Random& random) {
  const Eigen::Vector3d size = randomSize(random, 0.01, 0.2);
  return shapeOf(random() % kKinds, size);
}

ConvexGeometry randomGeometry(Random& random) {
  const Eigen::Vector3d size = randomSize(random, 0.001, 0.3);
  const std::size_t kind = random() % (kKinds + 2);
  if (kind < kKinds) {
    return std::visit([](const auto& shape) -> ConvexGeometry { return shape; },
                      shapeOf(kind, size));
  }
  return kind == kKinds ? ConvexGeometry(Cylinder{size.x(), size.y()}) : randomHull(random);
}

ScrewMotion randomMotion(Random& random, double reach, double travel, double turn) {
  ScrewMotion motion;
  motion.start = randomPose(random, reach);
  motion.travel = randomPoint(random, travel);
  motion.turn = uniform(random, 0.0, turn) * randomPoint(random, 1.0).normalized();
  return motion;
}

SweptContact meetConvex(const ConvexGeometry& a, const ScrewMotion& motion_a,
                        const ConvexGeometry& b, const ScrewMotion& motion_b,
                        double contact_distance) {
  static thread_local const auto workspace = std::make_unique<ConvexWorkspace>();
  ConvexWarmStart warm;
  ConvexSearch search{*workspace, warm};
  SweepLimits limits;
  limits.contact_distance = contact_distance;
  limits.budget = 100000;
  return firstContact(MovingConvex{a, ballOf(a), motion_a}, MovingConvex{b, ballOf(b), motion_b},
                      limits, search);
}

PlateCrossing randomCrossing(Random& random, double half_width) {
  PlateCrossing scene;
  scene.plate = Box{{half_width, half_width, uniform(random, 0.0005, 0.0025)}};
  scene.still = screwBetween(Pose(), Pose());
  do {
    const Eigen::Vector3d size(uniform(random, 0.005, 0.05), uniform(random, 0.005, 0.05),
                               uniform(random, 0.0005, 0.0025));
    scene.body = random() % 2 == 0 ? ConvexGeometry(Box{size})
                                   : ConvexGeometry(Cylinder{size.z(), size.x()});
    scene.crossing = crossingMotion(random);
  } while (distanceAt(scene, 0.0) <= 1e-4 || distanceAt(scene, 1.0) <= 1e-4 ||
           poseAt(scene.crossing, 1.0).translation.z() >= 0.0);
  return scene;
}

double distanceAt(const PlateCrossing& scene, double time) {
  return measureCold(scene.plate, poseAt(scene.still, time), scene.body,
                     poseAt(scene.crossing, time))
      .measured.distance;
}

std::optional<int> firstOverlap(const PlateCrossing& scene, int count) {
  constexpr double kRounding = 1e-9;
  const Ball ball = ballOf(scene.body);
  const double speed =
      velocityAt(scene.crossing, ball.center).norm() + scene.crossing.turn.norm() * ball.radius;
  for (int step = 0; step <= count;) {
    const double distance = distanceAt(scene, static_cast<double>(step) / count);
    if (distance <= 0.0) {
      return step;
    }
    step += 1 + static_cast<int>(std::max(0.0, distance - kRounding) / speed * count);
  }
  return std::nullopt;
}

bool isAsEveryStepShows(const PlateCrossing& scene, int count) {
  int step = 0;
  while (step <= count && distanceAt(scene, static_cast<double>(step) / count) > 0.0) {
    ++step;
  }
  return firstOverlap(scene, count).value_or(count + 1) == step;
}

}  // namespace collision_monitor::test
