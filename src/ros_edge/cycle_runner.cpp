// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/cycle_runner.h"

#include <ros/console.h>

#include <algorithm>
#include <utility>

#include "ros_edge/sentences.h"

namespace collision_monitor {
namespace {

using Clock = std::chrono::steady_clock;

Clock::duration seconds(double value) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(value));
}

double toSeconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

/// A timer slower than the heartbeat would let the heart stop.
double periodOf(const Parameters& parameters) {
  return 1.0 / std::max(parameters.rate, parameters.heartbeat_rate);
}

/// How far apart two cycles by poses are on the average, at least. Poses that come `rate` times a
/// second by another clock come a little sooner by this one.
double poseIntervalOf(const Parameters& parameters) {
  constexpr double kClockTolerance = 0.01;
  return (1.0 - kClockTolerance) * periodOf(parameters);
}

/// How long the pose trigger waits for news: links that grow stale meanwhile must be told soon.
double idlePeriodOf(const Parameters& parameters) {
  constexpr double kShortest = 1e-3;
  return std::max(kShortest, std::min(1.0 / parameters.heartbeat_rate, 0.25 * parameters.max_age));
}

}  // namespace

CycleRunner::CycleRunner(const ros::NodeHandle& private_node, Inputs inputs,
                         std::shared_ptr<const MonitorSetup> setup)
    : store_(inputs.transforms), joints_(inputs.joints), publishers_(private_node) {
  replaceSetup(std::move(setup));
  thread_ = std::thread([this] { run(); });
}

CycleRunner::~CycleRunner() {
  is_running_ = false;
  store_.wake();
  thread_.join();
}

void CycleRunner::replaceSetup(std::shared_ptr<const MonitorSetup> setup) {
  // Made here, outside the lock and off the cycle's thread: it allocates.
  auto next = std::make_unique<Watch>(setup, store_, joints_);
  const std::lock_guard<std::mutex> lock(mutex_);
  current_ = std::move(setup);
  next_ = std::move(next);
}

std::shared_ptr<const MonitorSetup> CycleRunner::currentSetup() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return current_;
}

void CycleRunner::setEnabled(bool is_enabled) {
  if (is_enabled) {
    enabling_.switchOn();
  } else {
    enabling_.switchOffFor(currentSetup()->parameters.disable_timeout);
  }
  store_.wake();
}

void CycleRunner::run() {
  planned_start_ = Clock::now();
  while (is_running_) {
    takeOverSetup();
    runOnce();
    waitForNext();
  }
}

void CycleRunner::takeOverSetup() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!next_) {
    return;
  }
  if (watch_) {
    succeedWatch(*watch_, *next_);
  }
  watch_ = std::move(next_);
  publishers_.startWatch(*watch_);
  last_state_ = Clock::time_point();
}

void CycleRunner::succeedWatch(Watch& former, Watch& next) {
  if (!facts_.is_enabled) {
    former.speakAgain();
  }
  for (const LinkPairIndex pair : next.succeed(former)) {
    publishers_.publishDropped(former, pair);
  }
  if (!facts_.is_enabled) {
    next.fallSilent();
  }
}

void CycleRunner::waitForNext() {
  const Parameters& parameters = watch_->fixed->parameters;
  const Clock::time_point now = Clock::now();
  // A cycle that came late shifts those after it; they do not catch up in a burst.
  if (parameters.trigger == Trigger::timer) {
    planned_start_ = std::max(planned_start_ + seconds(periodOf(parameters)), now);
  } else {
    // Poses may come early after one that came late, so they may be one interval ahead.
    const Clock::duration interval = seconds(poseIntervalOf(parameters));
    planned_start_ = std::max(planned_start_ + interval, now - interval);
    // News first: where they come no faster than `rate`, there is nothing left to sleep.
    store_.waitForNews(seen_data_, now + seconds(idlePeriodOf(parameters)));
  }
  std::this_thread::sleep_until(planned_start_);
}

void CycleRunner::runOnce() {
  const Clock::time_point start = Clock::now();
  facts_.now = store_.readTime();
  const bool was_enabled = facts_.is_enabled;
  const ros::SteadyTime steady_now = ros::SteadyTime::now();
  facts_.is_enabled = enabling_.isOn(steady_now);
  facts_.enabled_again_in = enabling_.secondsUntilOn(steady_now);
  bool is_new = readPoses(facts_.now);
  if (facts_.is_enabled != was_enabled) {
    ROS_WARN_STREAM("the monitor is switched " << (facts_.is_enabled ? "on" : "off"));
    if (facts_.is_enabled) {
      watch_->speakAgain();
    } else {
      watch_->fallSilent();
    }
    is_new = true;
  }
  runCycle(watch_->setup(), watch_->poses, watch_->buffers);
  ++facts_.cycles;
  countStep(watch_->buffers.sweep, facts_.steps);
  facts_.cycle_time = toSeconds(Clock::now() - start);
  publish(is_new);
  statistics_.addCycle(facts_.cycle_time);
  if (toSeconds(Clock::now() - start) > periodOf(watch_->fixed->parameters)) {
    ++facts_.overruns;
  }
}

/// @return true when something differs from the last cycle.
bool CycleRunner::readPoses(const ros::Time& now) {
  const TransformStore::Version version = store_.version();
  seen_data_ = version.data;
  if (version.jumps != seen_jumps_) {
    seen_jumps_ = version.jumps;
    joints_.forget();
    watch_->forget();
    ROS_WARN("time jumped back; poses are unknown until new transforms come");
  }
  return watch_->read(now);
}

void CycleRunner::publish(bool is_new) {
  const Watch& watch = *watch_;
  if (facts_.is_enabled) {
    publishers_.publishChanges(watch);
  }
  const Clock::time_point now = Clock::now();
  const std::uint8_t level = levelOf(watch, facts_);
  const double since_state = toSeconds(now - last_state_);
  const bool is_due = since_state >= 1.0 / watch.fixed->parameters.heartbeat_rate;
  if (!is_new && !is_due && level == last_level_) {
    return;
  }
  last_level_ = level;
  last_state_ = now;
  const State& state = publishers_.publishCycle(watch, facts_);
  publishers_.publishMarkers(watch);
  constexpr double kSummaryPeriod = 0.2;
  if (toSeconds(now - last_summary_) >= kSummaryPeriod) {
    last_summary_ = now;
    summarize(state);
  }
}

void CycleRunner::summarize(const State& state) {
  CycleSummary summary;
  summary.level = state.level;
  summary.sentence = state.sentence;
  summary.age = state.age;
  summary.time_to_contact = state.time_to_contact;
  summary.speed_scale = state.speed_scale;
  summary.pairs = state.pairs_checked;
  summary.candidates = state.pairs_candidates;
  summary.measured = state.pairs_measured;
  summary.refined = state.pairs_refined;
  summary.left = state.pairs_left;
  summary.swept = state.pairs_swept;
  summary.step = state.step;
  summary.step_limit = state.step_limit;
  summary.step_cap = state.step_cap;
  summary.step_warning = state.step_warning;
  summary.steps = facts_.steps;
  summary.unknown_links = state.unknown_links;
  summary.cycles = state.cycles;
  summary.overruns = state.overruns;
  statistics_.setSummary(std::move(summary));
}

}  // namespace collision_monitor
