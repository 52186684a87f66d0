// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision_monitor/model/kinematics.h"

/// Forward kinematics of several states of one model at once. placeLinks of kinematics.h is the
/// plain twin.
///
/// Frames, units: as kinematics.h.
namespace collision_monitor {

/// States that are placed together, a multiple of the lanes of every instruction set.
constexpr std::size_t kStateCount = 8;

/// One number of each of these states.
struct alignas(64) StateNumber {
  double of[kStateCount];
};

/// A pose of each of these states: the translation, then the z, x and y axes.
struct StatePose {
  StateNumber translation[3];
  StateNumber axis_z[3];
  StateNumber axis_x[3];
  StateNumber axis_y[3];
};

Pose poseOf(const StatePose& pose, std::size_t state) noexcept;

/// The frame that a moving joint moves, turned so that its z axis is the joint's axis.
struct MovingFrame {
  static constexpr std::uint32_t kWorld = 0xffffffffU;

  JointType type{JointType::revolute};
  std::uint32_t parent{kWorld};  ///< into KinematicsPlan::frames, stands before
  std::size_t first_variable{0};
  double multiplier{1.0};  ///< these two of a mimic joint
  double offset{0.0};
  Pose parent_from_frame;  ///< at zero; the fixed joints between are in it
};

/// Where a link stands: fixed to a moving frame, or to the world.
struct LinkPlace {
  std::uint32_t frame{MovingFrame::kWorld};
  Pose frame_from_link;
};

/// A model's kinematics without what does not move.
struct KinematicsPlan {
  std::vector<MovingFrame> frames;
  std::vector<LinkPlace> links;  ///< by LinkId
  std::size_t variable_count{0};
};

/// Where the robots stand, and joints that are held. What is not known has a pose of NaN.
struct StandingPoses {
  std::vector<Pose> world_from_root;      ///< by RobotId
  std::vector<std::optional<Pose>> held;  ///< by JointId: parent_from_child
};

/// Every joint moves. @pre as placeLinks.
StandingPoses standingAt(const RobotModel& model, const std::vector<Pose>& world_from_root);

KinematicsPlan planKinematics(const RobotModel& model, const StandingPoses& standing);

/// Places every frame of the plan in kStateCount states.
///
/// Error: as placeLinks, some ulps of the lengths and 1 each; the same bytes with every instruction
/// set.
/// Limits: as kinematics.h: variables that are not finite give poses that are not, in that state.
/// Source: as kinematics.h; sine and cosine: Cody, Waite, "Software Manual for the Elementary
/// Functions" (1980), chapter 8, with the polynomials of Sun's fdlibm (1993).
/// @pre `variables` has one entry a variable, `world_from_frame` one a frame.
void placeFrames(const KinematicsPlan& plan, const std::vector<StateNumber>& variables,
                 std::vector<StatePose>& world_from_frame) noexcept;

}  // namespace collision_monitor
