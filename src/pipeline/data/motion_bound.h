// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "model/kinematics/joint_path.h"
#include "motion/conservative_advancement.h"
#include "motion/relative_motion.h"

namespace collision_monitor {

/// A moving joint between the two links of a pair.
struct ChainJoint {
  LinkId child{};        ///< its axis passes through this link's frame
  Eigen::Vector3d axis;  ///< unit, in the frame of `child`
  bool is_prismatic{false};
  std::size_t path_joint{0};  ///< index into JointPath::joints of the joint that moves it
  double factor{1.0};  ///< how B moves beyond the joint, seen from A, per motion of that joint
};

/// The link and its ancestors, up to the root.
std::vector<LinkId> linksToRoot(const RobotModel& model, LinkId link);

/// The joints between two links that the path moves, from A to B.
struct LinkChain {
  LinkId a{};
  LinkId b{};
  std::vector<ChainJoint> joints;
};

LinkChain chainBetween(const RobotModel& model, const JointPath& path, LinkId a, LinkId b);

/// By LinkId: a ball that holds all bodies of a link, in the link frame.
std::vector<Ball> linkBalls(const CycleSetup& setup);

/// How far links' balls are from the axes of joints at one time. Measures each when it is first
/// asked for: pairs share most of them.
class JointLevers {
 public:
  /// @param balls by LinkId, see linkBalls
  JointLevers(std::vector<Ball> balls, const RobotModel& model, const JointPath& path);

  /// Begins another time. @param world_from_link must stay until the next one
  void moveTo(const std::vector<Pose>& world_from_link) noexcept;

  /// [m] From the axis of a revolute joint to the center of a ball.
  double of(const ChainJoint& joint, LinkId link) noexcept {
    Lever& lever = levers_[index(link) * axes_ + axis_of_[index(joint.child)]];
    if (lever.time != time_) {
      lever = {measure(joint, link), time_};
    }
    return lever.length;
  }
  double radius(LinkId link) const noexcept { return balls_[index(link)].radius; }

 private:
  struct Lever {
    double length{0.0};
    std::uint64_t time{0};
  };
  double measure(const ChainJoint& joint, LinkId link) const noexcept;

  std::vector<Ball> balls_;
  const std::vector<Pose>* world_from_link_{nullptr};
  std::size_t axes_{0};                 ///< of joints that the path moves
  std::vector<std::uint32_t> axis_of_;  ///< by LinkId: of the joint that moves it
  std::vector<Lever> levers_;           ///< by link, then by axis
  std::uint64_t time_{0};               ///< how often moveTo was called
};

/// [m] An upper bound of how much nearer two links come. `travels` holds the travel of each path
/// joint.
///
/// Only joints between the two links count. A joint turns everything beyond it about its axis. A
/// point that stays within r of the axis moves at most r times the angle, and joints farther out
/// increase r by the motion that they cause. Each joint may be seen as moving either side, so the
/// chain may be split in two anywhere: the split of the least bound is taken.
///
/// @param levers at any one time of the motion.
/// Source: Schwarzer, Saha, Latombe, "Adaptive Dynamic Collision Checking for Single and Multiple
/// Articulated Robots in Complex Environments" (2005), section IV. Departs from it: lever arms are
/// those of the present pose, not of the worst one, and the chain is split.
double boundMotion(const LinkChain& chain, const std::vector<double>& travels,
                   JointLevers& levers) noexcept;

/// How B moves, seen from A, in a part of a path. World frame.
/// @param world_from_link in the middle of the part; `steps` by path joint.
RelativeMotion relativeMotion(const LinkChain& chain, const std::vector<Ball>& balls,
                              const std::vector<Pose>& world_from_link,
                              const std::vector<JointStep>& steps) noexcept;

/// The same chain from B to A.
LinkChain reversed(const LinkChain& chain);

}  // namespace collision_monitor
