// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision_monitor/model/kinematics.h"

/// Forward kinematics of several states of one model at once. placeLinks in kinematics.h is the
/// scalar version.
///
/// Frames, units: as kinematics.h.
namespace collision_monitor {

/// States that are placed together: a multiple of the lane count of every instruction set.
constexpr std::size_t kStateCount = 8;

/// One number for each of these states.
struct alignas(64) StateNumber {
  double of[kStateCount];
};

/// A pose for each of these states: the translation, then the z, x and y axes.
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
  std::uint32_t parent{kWorld};  ///< index into KinematicsPlan::frames, smaller than this frame's
  std::size_t first_variable{0};
  double multiplier{1.0};  ///< of a mimic joint, as is the offset
  double offset{0.0};
  Pose parent_from_frame;  ///< at joint position zero; includes the fixed joints in between
};

/// Where a link is: fixed to a moving frame, or to the world.
struct LinkPlace {
  std::uint32_t frame{MovingFrame::kWorld};
  Pose frame_from_link;
};

/// A model's kinematics without fixed and held joints.
struct KinematicsPlan {
  std::vector<MovingFrame> frames;
  std::vector<LinkPlace> links;  ///< by LinkId
  std::size_t variable_count{0};
};

/// Poses of the roots, and joints that are held. Unknown poses are NaN.
struct StandingPoses {
  std::vector<Pose> world_from_root;      ///< by RobotId
  std::vector<std::optional<Pose>> held;  ///< by JointId: parent_from_child
};

/// Root poses with no joint held. @pre as placeLinks.
StandingPoses standingAt(const RobotModel& model, const std::vector<Pose>& world_from_root);

KinematicsPlan planKinematics(const RobotModel& model, const StandingPoses& standing);

/// Places every frame of the plan in kStateCount states.
///
/// Error: as placeLinks, some ulps of the lengths and 1 each; the same bytes on every instruction
/// set.
/// Limits: as kinematics.h; variables that are not finite affect only their own state.
/// Source: as kinematics.h; sine and cosine: Cody, Waite, "Software Manual for the Elementary
/// Functions" (1980), chapter 8, with the polynomials of Sun's fdlibm (1993).
/// @pre `variables` has one entry per variable, `world_from_frame` one per frame.
void placeFrames(const KinematicsPlan& plan, const std::vector<StateNumber>& variables,
                 std::vector<StatePose>& world_from_frame) noexcept;

}  // namespace collision_monitor
