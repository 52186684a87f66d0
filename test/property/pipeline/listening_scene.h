// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/random_poses.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/sample_meshes.h"

// Meshes that drift past each other, watched with and without a listener.
namespace collision_monitor::test::measure_told_laws {

constexpr std::uint32_t kAmple = 10000000;
constexpr std::int64_t kPeriod = 1000000;  // [ns]

inline CycleSetup bodiesSetup() {
  SetupOptions options;
  options.default_limits.max_shapes = 2;
  CycleSetup setup = geometrySetup({bumpyMesh(0.2, 16), angleMesh(), Cylinder{0.1, 0.05},
                                    Box{{0.1, 0.04, 0.03}}, bumpyMesh(0.1, 12)},
                                   options);
  setup.refine.budget = kAmple;
  setup.ahead.stop.release_time = 1e-9;  // no scale depends on earlier ones
  return setup;
}

/// A box without a lid.
inline TriangleMesh trayMesh(const Eigen::Vector3d& half_extents) {
  TriangleMesh mesh = boxMesh(half_extents);
  std::vector<std::array<std::uint32_t, 3>>& triangles = mesh.triangles;
  const auto isOfLid = [&](const auto& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](std::uint32_t corner) { return mesh.vertices[corner].z() > 0.0; });
  };
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), isOfLid), triangles.end());
  return mesh;
}

/// Meshes that mostly overlap, two of them open.
inline CycleSetup overlappingSetup() {
  CycleSetup setup =
      geometrySetup({bumpyMesh(0.2, 16), angleMesh(), trayMesh({0.15, 0.15, 0.1}),
                     trayMesh({0.1, 0.1, 0.15}), bumpyMesh(0.05, 12), bumpyMesh(0.05, 16)},
                    {});
  setup.refine.budget = kAmple;
  setup.ahead.stop.release_time = 1e-9;
  return setup;
}

/// With many warnings.
inline CycleSetup crowdedSetup() {
  CycleSetup setup = bodiesSetup();
  setup.limits.warning_distance = 0.15;
  return setup;
}

/// Moves each link evenly for a while, then throws it somewhere else.
class Drift {
 public:
  /// @param speed [m/s] [rad/s] at most
  /// @param reach [m] of positions from the origin, where links are thrown to
  explicit Drift(const CycleSetup& setup, double speed = 1.0, double reach = 0.25)
      : speed_(speed), reach_(reach), poses_(randomLinkPoses(setup, reach, kSeed)), random_(kSeed) {
    poses_.stamp_ns = kPeriod;
    for (std::size_t link = 0; link < poses_.status.size(); ++link) {
      turn(link);
    }
  }

  /// Velocities are now and then unknown for a while.
  void hideVelocities() { hides_velocities_ = true; }

  const LinkPoses& next() {
    poses_.stamp_ns += kPeriod;
    for (std::size_t link = 0; link < poses_.status.size(); ++link) {
      if (random_() % 500 == 0) {
        poses_.world_from_link[link] = randomPose(random_, reach_);
        turn(link);
      }
      move(poses_.velocities.of_link[link], poses_.world_from_link[link]);
      if (hides_velocities_ && random_() % 200 == 0) {
        poses_.velocities.known[link] = random_() % 4 == 0 ? 0 : 1;
      }
    }
    return poses_;
  }

 private:
  static void move(const Twist& twist, Pose& pose) {
    constexpr double kSeconds = 1e-9 * static_cast<double>(kPeriod);
    const double angle = kSeconds * twist.angular.norm();
    const Eigen::Matrix3d turned =
        Eigen::AngleAxisd(angle, twist.angular.normalized()).toRotationMatrix();
    pose.rotation = turned * pose.rotation;
    pose.translation = turned * pose.translation + kSeconds * twist.linear;
  }
  void turn(std::size_t link) {
    poses_.velocities.of_link[link] = {randomPoint(random_, 0.2 * speed_),
                                       randomPoint(random_, speed_)};
    poses_.velocities.known[link] = 1;
  }

  double speed_;
  double reach_;
  bool hides_velocities_{false};
  LinkPoses poses_;
  Random random_;
};

/// Which way leads out of an overlap, and so whether it closes, depends on where it was first met.
inline bool isAnyEstimate(const PairDistances& distances) {
  return std::any_of(distances.pairs.begin(), distances.pairs.end(),
                     [](const PairDistance& pair) { return pair.quality == Quality::estimate; });
}

struct Watches {
  explicit Watches(const CycleSetup& setup, double tolerance = 0.0)
      : told(makeBuffers(setup, BroadPhaseKind::brute_force)),
        untold(makeBuffers(setup, BroadPhaseKind::brute_force)) {
    told.refine.limits.tolerance = untold.refine.limits.tolerance = tolerance;
    untold.refine.tells_all = false;
  }
  void run(const CycleSetup& setup, const LinkPoses& poses) {
    runCycle(setup, poses, told);
    runCycle(setup, poses, untold);
  }

  CycleBuffers told;
  CycleBuffers untold;
};

}  // namespace collision_monitor::test::measure_told_laws
