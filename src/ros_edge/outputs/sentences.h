// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pipeline/cycle/cycle_buffers.h"
#include "ros_edge/poses/floating_parts.h"
#include "ros_edge/watch.h"

/// Sentences for people, without full stop.
namespace collision_monitor {

/// "12.35" with the given number of decimals. Same text as printf's %f in a quarter of its time;
/// some of these are made in every cycle.
std::string fixedText(double value, int decimals);

/// "4.2 mm", "120 mm", "1.23 m"; without sign.
std::string lengthText(double length);

/// "1.250 s"
std::string secondsText(double time);

/// Joined with semicolons.
std::string join(const std::vector<std::string>& texts);

/// "a is 12 mm from b" or "a overlaps b by 3.0 mm", plus the motion: "a is 12 mm from b, closing at
/// 0.20 m/s, contact in 0.06 s". For enclosing shapes it says so: "a is at least 12 mm from b".
std::string distanceSentence(const CycleSetup& setup, const PairDistance& distance);

/// The measured shapes that represent a link pair, as an index into the measured pairs: the
/// nearest, or the first to touch if their time decides the verdict; kNone if none was measured.
std::uint32_t speakerOf(const CycleSetup& setup, const CycleBuffers& buffers,
                        LinkPairIndex link_pair);

/// For a measured pair: its state now, or that it touched since the last cycle.
std::string pairSentence(const Watch& watch, LinkPairIndex link_pair);

/// The link pair that speaks for several: the nearest of those that were measured.
struct Speaker {
  LinkPairIndex pair{kNone};  ///< kNone: none was measured
  double distance{0.0};       ///< [m] of it
  std::size_t count{0};       ///< for how many it speaks

  void add(const Watch& watch, LinkPairIndex link_pair);
};

/// pairSentence of the speaker, and how many more there are.
std::string pairsSentence(const Watch& watch, const Speaker& speaker);

/// "clear", and the sentence about the closest pair if there is one.
std::string clearText(const std::string& closest);

/// " (and 2 more pairs)"; empty if there is only one.
std::string andMore(std::size_t count, const char* what);

/// Why nothing at all can be judged: there is no time, or nothing is checked; empty if it can.
std::string blindReason(const Watch& watch, const CycleFacts& facts);

/// "switched off for another 12 s; "; empty while it is on.
std::string offText(const CycleFacts& facts);

/// What a pair's change of verdict means.
std::string changeSentence(const Watch& watch, const VerdictChange& change);

/// Why a link is unknown: "no transform for 0.52 s"
std::string reasonSentence(const Watch& watch, LinkId link);

/// "link a is unknown: no transform for 0.52 s"
std::string unknownSentence(const Watch& watch, LinkId link);

/// "no time on /clock yet", "the clock has stood still for 1.2 s: nothing comes on /clock ..."
/// @pre it has a fault
std::string clockSentence(const ClockState& clock);

/// "the part of robot 'left' from link 'left/base' on floats: no transform from 'world' to
/// 'left/base' yet; its 54 own pairs are checked, 120 pairs with others are unknown"
std::string floatingSentence(const Watch& watch, const FloatingPart& part);

/// Says that poses come too rarely, how often they are needed, and whether continuous checks
/// between them cover it; empty if poses are frequent enough.
std::string stepSentence(const Watch& watch);

/// The state of the whole monitor.
std::string stateSentence(const Watch& watch, const CycleFacts& facts);

/// "known", "stale", "missing", "not finite" or "contradicted".
const char* statusText(LinkStatus status) noexcept;

}  // namespace collision_monitor
