// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/data/motion_bound.h"
#include "pipeline/trajectory/path_poses.h"
#include "support_fcl/fcl_mesh.h"

/// A joint path checked with FCL at samples.
namespace collision_monitor::test {

/// The collision meshes, boxes and cylinders of a robot for FCL. Other geometries are left out,
/// which only makes FCL faster.
class FclRobot {
 public:
  explicit FclRobot(const RobotModel& model);

  void place(LinkId link, const Pose& world_from_link);
  bool overlaps(const CheckedLinkPair& pair) const;
  /// [m] 0 or less if surfaces cross.
  double distance(const CheckedLinkPair& pair) const;

 private:
  std::vector<std::vector<fcl::CollisionObjectd>> objects_;  ///< by LinkId
};

/// The data that every sampling needs.
struct FclPath {
  FclPath(const CycleSetup& cycle_setup, const JointPath& joint_path, const LinkPoses& start);

  const CycleSetup& setup;
  const JointPath& path;
  PathPoses poses;
  FclRobot robot;
  JointLevers levers;
  std::vector<LinkChain> chains;  ///< by LinkPairIndex
};

/// The number of samples from each way-point to the next, so that no two links approach by more
/// than `step` [m] between samples. Finds contacts deeper than half of that.
std::vector<std::uint64_t> countSamples(FclPath& all, double step);

/// Tests overlaps at the samples between every `part`-th way-point and the next, pair by pair, up
/// to `contact_times` [s] by LinkPairIndex.
/// @return samples taken.
std::uint64_t sampleOverlaps(FclPath& all, const std::vector<std::uint64_t>& samples,
                             std::size_t part, const std::vector<double>& contact_times);

/// Follows every pair by FCL's distances. Each distance carries it on for as long as the links
/// cannot consume it, until they are within `tolerance` [m].
/// @return distances measured; counts the pairs that come so near.
std::uint64_t followDistances(FclPath& all, double tolerance, std::size_t& contacts);

}  // namespace collision_monitor::test
