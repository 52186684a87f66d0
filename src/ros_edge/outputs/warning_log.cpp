// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/warning_log.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "model/object_links.h"
#include "model/place.h"
#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {
namespace {

/// [s] Wall time between two lines with one cause.
constexpr double kPeriod = 1.0;

bool isTooSoon(const ros::SteadyTime& last, const ros::SteadyTime& now, double period = kPeriod) {
  return !last.isZero() && (now - last).toSec() < period;
}

}  // namespace

/// Whether another line about a pair may follow those of the last second. Counts those that may
/// not. Contacts always may.
bool WarningLog::hasRoomFor(const PairWarning& warning, const ros::SteadyTime& now) {
  constexpr std::size_t kMost = 20;
  if (!isTooSoon(burst_, now)) {
    tellLeftOut(now);
    burst_ = now;
    lines_ = 0;
  }
  const bool has_room = lines_ < kMost || warning.after == PairWarning::CONTACT;
  ++(has_room ? lines_ : left_out_);
  return has_room;
}

void WarningLog::tellLeftOut(const ros::SteadyTime& now) {
  if (left_out_ > 0 && !isTooSoon(burst_, now)) {
    log_.warn("and " + std::to_string(left_out_) +
              " more changes of pairs within a second, which the topic `warnings` has");
    left_out_ = 0;
  }
}

/// Keeps only recent changes.
void WarningLog::forgetOld(const ros::SteadyTime& now) {
  if (last_of_change_.size() < most_kept_) {
    return;
  }
  for (auto it = last_of_change_.begin(); it != last_of_change_.end();) {
    it = isTooSoon(it->second, now) ? std::next(it) : last_of_change_.erase(it);
  }
  most_kept_ = std::max(kFewKept, 2 * last_of_change_.size());
}

void WarningLog::logChange(const PairWarning& warning, const ros::SteadyTime& now) {
  forgetOld(now);
  const LinkDistance& pair = warning.pair;
  ros::SteadyTime& last =
      last_of_change_[pair.link_a + '\n' + pair.link_b + '\n' + std::to_string(warning.after)];
  if (isTooSoon(last, now)) {
    return;
  }
  last = now;
  if (!hasRoomFor(warning, now)) {
    return;
  }
  switch (warning.after) {
    case PairWarning::CONTACT:
      log_.warn("contact: " + warning.sentence);
      break;
    case PairWarning::WARNING:
      log_.warn("near: " + warning.sentence);
      break;
    case PairWarning::UNKNOWN:
      log_.warn("unknown: " + warning.sentence);
      break;
    default:
      log_.info("clear: " + warning.sentence);
      break;
  }
}

void WarningLog::logUnknownLinks(const Watch& watch) {
  const std::vector<LinkId>& unknown = watch.unknown().links();
  const ros::SteadyTime now = ros::SteadyTime::now();
  tellLeftOut(now);
  if (last_unknown_.isZero()) {
    last_unknown_ = now;  // at the start the first poses are still on their way
  }
  if (unknown == told_unknown_ || isTooSoon(last_unknown_, now)) {
    return;
  }
  last_unknown_ = now;
  told_unknown_ = unknown;
  if (unknown.empty()) {
    log_.info("every checked pair of links is known");
    return;
  }
  for (const FloatingPart& part : watch.unknown().parts()) {
    log_.warn("unknown: " + floatingSentence(watch, part));
  }
  // One line per cause: a silent joint makes every link behind it unknown.
  std::map<std::string, std::vector<std::string>> links_of_cause;
  for (const LinkId link : watch.unknown().loneLinks()) {
    links_of_cause[reasonSentence(watch, link)].push_back(nameInText(watch.setup().model, link));
  }
  for (const auto& [cause, links] : links_of_cause) {
    log_.warn("unknown: " + someOf(links) + ": " + cause);
  }
}

void WarningLog::logStep(const Watch& watch) {
  constexpr double kStepPeriod = 10.0;  // [s]
  const StepLimit& step = watch.buffers.sweep.step;
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (step.on_way.is_exceeded) {
    if (!isTooSoon(last_step_, now, kStepPeriod)) {
      last_step_ = now;
      log_.warn(stepSentence(watch));
    }
  } else if (step.at_poses.is_exceeded && !has_told_cap_) {
    has_told_cap_ = true;
    log_.info(stepSentence(watch) + " (said once; /diagnostics goes on)");
  }
}

}  // namespace collision_monitor
