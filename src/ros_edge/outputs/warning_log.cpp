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

constexpr std::uint64_t kVerdicts = 4;  // how many there are

bool isTooSoon(const ros::SteadyTime& last, const ros::SteadyTime& now, double period = kPeriod) {
  return !last.isZero() && (now - last).toSec() < period;
}

}  // namespace

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

void WarningLog::logChange(const VerdictChange& change, const std::string& sentence) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  forgetOld(now);
  ros::SteadyTime& last = last_of_change_[kVerdicts * std::uint64_t{change.link_pair} +
                                          static_cast<std::uint64_t>(change.after)];
  if (isTooSoon(last, now)) {
    return;
  }
  last = now;
  switch (change.after) {
    case Verdict::contact:
      log_.warn("contact: " + sentence);
      break;
    case Verdict::warning:
      log_.warn("near: " + sentence);
      break;
    case Verdict::unknown:
      log_.warn("unknown: " + sentence);
      break;
    case Verdict::clear:
      log_.info("clear: " + sentence);
      break;
  }
}

void WarningLog::logUnknownLinks(const Watch& watch) {
  const std::vector<LinkId>& unknown = watch.unknown().links();
  const ros::SteadyTime now = ros::SteadyTime::now();
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

void WarningLog::startWatch(const std::vector<LinkPairIndex>& pair_to) {
  std::unordered_map<std::uint64_t, ros::SteadyTime> carried;
  for (const auto& [change, time] : last_of_change_) {
    const std::uint64_t pair = change / kVerdicts;
    if (pair < pair_to.size() && pair_to[pair] != kNone) {
      carried[kVerdicts * std::uint64_t{pair_to[pair]} + change % kVerdicts] = time;
    }
  }
  last_of_change_.swap(carried);
  told_unknown_.clear();
}

}  // namespace collision_monitor
