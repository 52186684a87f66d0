// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pipeline/cycle/cycle_buffers.h"
#include "ros_edge/poses/floating_parts.h"
#include "ros_edge/watch.h"

/// What a person reads: one sentence each, without full stop.
namespace collision_monitor {

/// "12.35": with so many decimals, as printf's %f has them, in a quarter of its time: some of it is
/// said in every cycle.
std::string fixedText(double value, int decimals);

/// "4.2 mm", "120 mm", "1.23 m"; without sign.
std::string lengthText(double length);

/// "1.250 s"
std::string secondsText(double time);

/// With semicolons between.
std::string join(const std::vector<std::string>& texts);

/// "a is 12 mm from b" or "a overlaps b by 3.0 mm", and how they move: "a is 12 mm from b, closing
/// at 0.20 m/s, contact in 0.06 s". Says where the number is that of the enclosing shapes: "a is at
/// least 12 mm from b".
std::string distanceSentence(const CycleSetup& setup, const PairDistance& distance);

/// The measured shapes that a pair of links is judged by, as an index into the measured pairs: the
/// nearest, or those that touch first if that is why they matter; kNone if none was measured.
std::uint32_t speakerOf(const CycleSetup& setup, const CycleBuffers& buffers,
                        LinkPairIndex link_pair);

/// What a pair's change of verdict means.
std::string changeSentence(const Watch& watch, const VerdictChange& change);

/// Why a link is unknown: "no transform for 0.52 s"
std::string reasonSentence(const Watch& watch, LinkId link);

/// "link a is unknown: no transform for 0.52 s"
std::string unknownSentence(const Watch& watch, LinkId link);

/// "no time on /clock yet", "the clock has stood still for 1.2 s: nothing comes on /clock ..."
/// @pre it has a fault
std::string clockSentence(const ClockState& clock);

/// Parts that float beside the main one and have pairs of their own, which are known.
std::vector<FloatingPart> partsWithPairs(const Watch& watch);

/// The unknown links (findUnknownLinks) that are of none of these parts, into `links`.
void findLoneLinks(const Watch& watch, std::vector<LinkId>& links);

/// "the part of robot 'left' from link 'left/base' on floats: no transform from 'world' to
/// 'left/base' yet; its 54 own pairs are checked, 120 pairs with others are unknown"
std::string floatingSentence(const Watch& watch, const FloatingPart& part);

/// Poses that come too seldom, how often they are needed, and whether the look at the way between
/// them covers it; empty if they do not.
std::string stepSentence(const Watch& watch);

/// The state of the whole.
std::string stateSentence(const Watch& watch, const CycleFacts& facts);

/// "known", "stale", "missing", "not finite" or "contradicted".
const char* statusText(LinkStatus status) noexcept;

}  // namespace collision_monitor
