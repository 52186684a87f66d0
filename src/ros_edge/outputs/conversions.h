// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/Contacts.h>
#include <collision_monitor/LinkDistance.h>
#include <collision_monitor/PairWarning.h>
#include <collision_monitor/State.h>
#include <geometry_msgs/Pose.h>

#include "pipeline/answers/gradient_row.h"
#include "ros_edge/watch.h"

/// Results of a cycle as messages. Ids become names here and nowhere else. Messages are
/// filled in place, so that one that is kept from cycle to cycle keeps its memory.
namespace collision_monitor {

std_msgs::Header makeHeader(std::int64_t stamp_ns, const std::string& frame);

void toMessage(const Eigen::Vector3d& point, geometry_msgs::Point& message);
void toMessage(const Eigen::Vector3d& vector, geometry_msgs::Vector3& message);
void toMessage(const Pose& pose, geometry_msgs::Pose& message);

/// What a measured pair calls one of its bodies: the shape, or the element that was refined to.
const std::string& shapeName(const CycleSetup& setup, const PairDistance& distance, BodyId body);

/// The contact of two links on their way to this cycle's poses, in which they are apart again; null
/// if there was none.
const PassedContact* passedOf(const Watch& watch, LinkPairIndex link_pair);

/// [s] after the last cycle's data: when that contact began; NaN if there was none.
double passedAt(const Watch& watch, LinkPairIndex link_pair);

/// The frame of what is said of a link: the world's or, in a part that floats, its top link's.
std::string frameOf(const MonitorSetup& setup, const LinkPoses& poses, LinkId link);

/// A measured pair; its gradient row is left as it is.
void toMessage(const MonitorSetup& setup, const LinkPoses& poses, const PairDistance& distance,
               LinkDistance& message);
void toMessage(const CycleSetup& setup, const GradientRow& row, LinkDistance& message);
/// Their two parts: names, which are always the same for a pair and its being refined, and numbers.
void nameBodies(const CycleSetup& setup, const PairDistance& distance, LinkDistance& message);
void nameJoints(const CycleSetup& setup, const GradientRow& row, LinkDistance& message);
void fillNumbers(const PairDistance& distance, LinkDistance& message);
void fillNumbers(const GradientRow& row, LinkDistance& message);
/// No pair: no names, and numbers that are NaN.
void toUnknownMessage(LinkDistance& message);
/// A pair of links that is unknown: numbers are NaN.
void toUnknownMessage(const CycleSetup& setup, LinkId a, LinkId b, LinkDistance& message);
/// A checked pair: the shapes that speak for it (speakerOf), or NaN where nothing was measured. A
/// known pair that is out of reach was not measured; its distance is the reach then, a lower bound
/// without points.
void toMessage(const Watch& watch, LinkPairIndex link_pair, LinkDistance& message);

/// Whether a measured pair is one of `contacts`: those that hysteresis keeps in contact are, too.
bool isInContact(const Watch& watch, const PairDistance& distance);

void toMessage(const Watch& watch, Contacts& message);
void toMessage(const Watch& watch, const VerdictChange& change, PairWarning& message);
/// A pair that another set-up checks no more: clear as far as that goes, without numbers.
void toDroppedMessage(const Watch& former, LinkPairIndex pair, PairWarning& message);
void toMessage(const Watch& watch, const CycleFacts& facts, State& message);

/// What a controller may multiply its speed by: 0 while the monitor does not know or is switched
/// off.
double speedScaleOf(const Watch& watch, const CycleFacts& facts);

/// The level of a state: that of its worst pair, UNKNOWN if nothing is checked or there is
/// no time yet, at least WARNING while switched off.
std::uint8_t levelOf(const Watch& watch, const CycleFacts& facts);

}  // namespace collision_monitor
