// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "model/object_links.h"
#include "ros_edge/outputs/conversions.h"
#include "ros_edge/outputs/sentences.h"
#include "ros_edge/robots/robot_states.h"

namespace collision_monitor {
namespace {

static_assert(State::OK == static_cast<int>(Verdict::clear) &&
              State::WARNING == static_cast<int>(Verdict::warning) &&
              State::UNKNOWN == static_cast<int>(Verdict::unknown) &&
              State::CONTACT == static_cast<int>(Verdict::contact));
static_assert(PairWarning::CLEAR == static_cast<int>(Verdict::clear) &&
              PairWarning::WARNING == static_cast<int>(Verdict::warning) &&
              PairWarning::UNKNOWN == static_cast<int>(Verdict::unknown) &&
              PairWarning::CONTACT == static_cast<int>(Verdict::contact));

void fillCounters(const CycleCounters& counters, const CycleFacts& facts, State& message) {
  message.pairs_checked = static_cast<std::uint32_t>(counters.pairs);
  message.pairs_candidates = static_cast<std::uint32_t>(counters.candidates);
  message.pairs_culled = static_cast<std::uint32_t>(counters.candidates - counters.measured);
  message.pairs_measured = static_cast<std::uint32_t>(counters.measured);
  message.pairs_refined = static_cast<std::uint32_t>(counters.refined);
  message.pairs_left = static_cast<std::uint32_t>(counters.left + counters.swept_left);
  message.pairs_unknown = static_cast<std::uint32_t>(counters.unknown_pairs);
  message.pairs_swept = static_cast<std::uint32_t>(counters.swept);
  message.cycle_time = facts.cycle_time;
  message.cycles = facts.cycles;
  message.overruns = facts.overruns;
  message.steps_over_cap = facts.steps.over_cap;
}

void fillLinks(const Watch& watch, State& message) {
  const RobotModel& model = watch.setup().model;
  message.age = 0.0;
  // Objects are as old as what carries them.
  for (const Robot& robot : model.robots) {
    forOwnLinks(model, robot, [&](std::size_t link) {
      if (watch.poses.status[link] == LinkStatus::known) {
        message.age = std::max(message.age, watch.poses.age[link]);
      }
    });
  }
  message.unknown_links.clear();
  for (const LinkId link : watch.unknown().links()) {
    message.unknown_links.push_back(nameInText(model, link) + " (" +
                                    statusText(statusInWorld(watch.poses, link)) + ")");
  }
  for (const ListedRobot& robot : watch.fixed->listed) {
    if (!robot.id) {
      message.unknown_links.push_back(
          "robot " + robot.name + (robot.has_come ? " (faulty description)" : " (no description)"));
    }
  }
}

bool isBlind(const Watch& watch, const CycleFacts& facts) {
  return !blindReason(watch, facts).empty();
}

/// A robot that has not come may be about to touch.
double timeToContactOf(const Watch& watch, const CycleFacts& facts) {
  const double time = watch.buffers.events.time_to_contact;
  const bool is_beyond_horizon = std::isinf(time);
  return isBlind(watch, facts) || (is_beyond_horizon && isAnyMissing(*watch.fixed)) ? kUnknown
                                                                                    : time;
}

}  // namespace

double speedScaleOf(const Watch& watch, const CycleFacts& facts) {
  return isBlind(watch, facts) || !facts.is_enabled || isAnyMissing(*watch.fixed)
             ? 0.0
             : watch.buffers.memory.speed.scale;
}

std::uint8_t levelOf(const Watch& watch, const CycleFacts& facts) {
  const auto verdict = static_cast<std::uint8_t>(watch.buffers.events.overall);
  const std::uint8_t judged = isBlind(watch, facts) ? std::uint8_t{State::UNKNOWN} : verdict;
  const std::uint8_t level =
      isAnyMissing(*watch.fixed) ? std::max(judged, std::uint8_t{State::UNKNOWN}) : judged;
  return facts.is_enabled ? level : std::max(level, std::uint8_t{State::WARNING});
}

void toMessage(const Watch& watch, const VerdictChange& change, PairWarning& message) {
  message.header = makeHeader(watch.poses.stamp_ns, watch.fixed->world_frame);
  message.before = static_cast<std::uint8_t>(change.before);
  message.after = static_cast<std::uint8_t>(change.after);
  toMessage(watch, change.link_pair, message.pair);
  message.sentence = changeSentence(watch, change);
}

void toDroppedMessage(const Watch& former, LinkPairIndex pair, PairWarning& message) {
  const CycleSetup& setup = former.setup();
  const CheckedLinkPair& links = setup.checked[pair];
  message.header = makeHeader(former.poses.stamp_ns, former.fixed->world_frame);
  message.before = static_cast<std::uint8_t>(former.buffers.memory.reported[pair]);
  message.after = PairWarning::CLEAR;
  toUnknownMessage(setup, links.a, links.b, message.pair);
  message.sentence = nameInText(setup.model, links.a) + " and " + nameInText(setup.model, links.b) +
                     " are not checked any more";
}

void toMessage(const Watch& watch, const CycleFacts& facts, State& message) {
  message.header = makeHeader(watch.poses.stamp_ns, watch.fixed->world_frame);
  message.published_at = facts.now;
  const ros::WallTime wall_now = ros::WallTime::now();
  message.published_at_wall = ros::Time(wall_now.sec, wall_now.nsec);
  message.level = levelOf(watch, facts);
  message.sentence = stateSentence(watch, facts);
  message.enabled = facts.is_enabled ? 1 : 0;
  const std::uint32_t closest = watch.buffers.events.closest_of_all;
  message.has_closest = closest != kNone ? 1 : 0;
  if (closest != kNone) {
    const PairDistance& distance = watch.buffers.distances.pairs[closest];
    toMessage(*watch.fixed, watch.poses, distance, message.closest);
    message.closest.passed_at = passedAt(watch, watch.setup().link_pair_of[index(distance.pair)]);
  } else {
    toUnknownMessage(message.closest);
  }
  message.time_to_contact = timeToContactOf(watch, facts);
  message.speed_scale = speedScaleOf(watch, facts);
  fillRobotStates(watch, facts, blindReason(watch, facts), message.robots);
  fillLinks(watch, message);
  fillCounters(watch.buffers.counters, facts, message);
  message.pairs_ignored = watch.pairs_ignored;
  message.pairs_muted = watch.pairs_muted;
  message.muted_for = facts.muted_for;
  message.pairs_passed = static_cast<std::uint32_t>(watch.buffers.distances.passed.size());
  message.step = watch.buffers.sweep.step.step;
  message.step_limit = watch.buffers.sweep.step.on_way.longest;
  message.step_cap = watch.buffers.sweep.step.at_poses.longest;
  message.step_warning = stepSentence(watch);
}

}  // namespace collision_monitor
