// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/Contacts.h>
#include <collision_monitor/LinkDistance.h>
#include <collision_monitor/PairWarning.h>
#include <collision_monitor/State.h>
#include <geometry_msgs/Pose.h>

#include <array>

#include "pipeline/answers/contact_manifold.h"
#include "pipeline/answers/gradient_row.h"
#include "ros_edge/watch.h"

/// Converts results of a cycle to messages. Only here ids become names. Messages are filled in
/// place, so a message that is reused every cycle keeps its memory.
namespace collision_monitor {

std_msgs::Header makeHeader(std::int64_t stamp_ns, const std::string& frame);

void toMessage(const Eigen::Vector3d& point, geometry_msgs::Point& message);
void toMessage(const Eigen::Vector3d& vector, geometry_msgs::Vector3& message);
void toMessage(const Pose& pose, geometry_msgs::Pose& message);

/// Name of a body in a measured pair: that of the shape, or of the element that was refined.
const std::string& shapeName(const CycleSetup& setup, const PairDistance& distance, BodyId body);

/// The contact of two links between the last cycle and this one, in which they are apart again;
/// null if there was none.
const PassedContact* passedOf(const Watch& watch, LinkPairIndex link_pair);

/// [s] When that contact began, after the last cycle's data; NaN if there was none.
double passedAt(const Watch& watch, LinkPairIndex link_pair);

/// The frame for results about a link: the world's, or the top link's in a floating part.
std::string frameOf(const MonitorSetup& setup, const LinkPoses& poses, LinkId link);
std::string frameOf(const MonitorSetup& setup, PartId part);

/// Converts a measured pair; does not change the gradient row.
void toMessage(const MonitorSetup& setup, const LinkPoses& poses, const PairDistance& distance,
               LinkDistance& message);
void toMessage(const CycleSetup& setup, const GradientRow& row, LinkDistance& message);
/// The two halves of the above: names, which depend only on the pair and on whether it is refined,
/// and numbers.
void nameBodies(const CycleSetup& setup, const PairDistance& distance, LinkDistance& message);
void nameJoints(const CycleSetup& setup, const GradientRow& row, LinkDistance& message);
void fillNumbers(const PairDistance& distance, LinkDistance& message);
void fillNumbers(const GradientRow& row, LinkDistance& message);
/// No pair: empty names, and numbers that are NaN.
void toUnknownMessage(LinkDistance& message);
/// An unknown link pair: numbers are NaN.
void toUnknownMessage(const CycleSetup& setup, LinkId a, LinkId b, LinkDistance& message);
/// A checked pair, by the shapes that represent it (speakerOf), or NaN if it is unknown. A known
/// pair beyond the activation distance was not measured. Its distance is then the activation
/// distance: a lower bound without points.
void toMessage(const Watch& watch, LinkPairIndex link_pair, LinkDistance& message);

/// Where two links touch, half way between them; the normal is that of the pair.
struct ContactPoints {
  std::array<Eigen::Vector3d, ContactManifold::kMaxPoints> points;
  std::size_t size{0};      ///< at least 1
  const char* feature{""};  ///< as in Contact
};

/// All points of the contact or, if a mesh that is not convex touches, the one that was measured.
ContactPoints contactPointsOf(const Watch& watch, const PairDistance& distance);
ContactPoints onePointOf(const SignedDistance& measured);

/// Whether a measured pair belongs in `contacts`, including pairs that hysteresis keeps in contact.
bool isInContact(const Watch& watch, const PairDistance& distance);

void toMessage(const Watch& watch, Contacts& message);
void toMessage(const Watch& watch, const VerdictChange& change, PairWarning& message);
/// A pair that the new set-up no longer checks: reported as clear, without numbers.
void toDroppedMessage(const Watch& former, LinkPairIndex pair, PairWarning& message);
void toMessage(const Watch& watch, const CycleFacts& facts, State& message);

/// Factor for a controller's speed: 0 while the monitor is uncertain or switched off.
double speedScaleOf(const Watch& watch, const CycleFacts& facts);

/// The level of a state: that of its worst pair; UNKNOWN if nothing is checked or there is no time
/// yet; at least WARNING while switched off.
std::uint8_t levelOf(const Watch& watch, const CycleFacts& facts);

}  // namespace collision_monitor
