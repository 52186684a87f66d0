// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/data/motion_bound.h"
#include "pipeline/trajectory/path_poses.h"
#include "support_fcl/fcl_mesh.h"

/// A path of joints checked with FCL, by samples.
namespace collision_monitor::test {

/// The collision meshes of a robot for FCL; other geometries than meshes, boxes and cylinders are
/// left out, which only makes FCL faster.
class FclRobot {
 public:
  explicit FclRobot(const RobotModel& model);

  void place(LinkId link, const Pose& world_from_link);
  bool overlaps(const CheckedLinkPair& pair) const;
  /// [m] 0 or less when surfaces cross.
  double distance(const CheckedLinkPair& pair) const;

 private:
  std::vector<std::vector<fcl::CollisionObjectd>> objects_;  ///< by LinkId
};

/// What every sampling needs.
struct FclPath {
  FclPath(const CycleSetup& cycle_setup, const JointPath& joint_path, const LinkPoses& start);

  const CycleSetup& setup;
  const JointPath& path;
  PathPoses poses;
  FclRobot robot;
  std::vector<Ball> balls;        ///< by LinkId
  std::vector<LinkChain> chains;  ///< by LinkPairIndex
};

/// Samples between every way-point and the next, so many that no two links come nearer by more
/// than `step` [m] from one to the next. Sees what is deeper than half of that.
std::vector<std::uint64_t> countSamples(FclPath& all, double step);

/// Asks for overlaps in the samples between every `part`-th way-point and the next, pair after
/// pair until `contact_times` [s] by LinkPairIndex.
/// @return samples taken.
std::uint64_t sampleOverlaps(FclPath& all, const std::vector<std::uint64_t>& samples,
                             std::size_t part, const std::vector<double>& contact_times);

/// Follows every pair by FCL's distances: from one sample on for as long as the links cannot come
/// nearer by the distance, up to where they are within `tolerance` [m].
/// @return distances asked for; counts the pairs that get so near.
std::uint64_t followDistances(FclPath& all, double tolerance, std::size_t& contacts);

}  // namespace collision_monitor::test
