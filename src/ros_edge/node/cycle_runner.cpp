// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/node/cycle_runner.h"

#include <algorithm>
#include <utility>

#include "ros_edge/outputs/sentences.h"
#include "ros_edge/world/convert_objects.h"

namespace collision_monitor {
CycleRunner::CycleRunner(const ros::NodeHandle& private_node, Inputs inputs,
                         std::shared_ptr<const MonitorSetup> setup, LogThread& log)
    : private_node_(private_node),
      store_(inputs.transforms),
      joints_(inputs.joints),
      clock_(inputs.clock),
      log_(log),
      publishers_(private_node, log) {
  replaceWatch(makeWatch(std::move(setup)));
  thread_ = std::thread([this] { run(); });
}

CycleRunner::~CycleRunner() {
  is_running_ = false;
  store_.wake();
  thread_.join();
}

std::unique_ptr<Watch> CycleRunner::makeWatch(std::shared_ptr<const MonitorSetup> setup) const {
  auto watch = std::make_unique<Watch>(std::move(setup), store_, joints_);
  const std::shared_ptr<const MonitorSetup> former = currentSetup();
  if (!former || former->world.objects != watch->fixed->world.objects ||
      former->world_frame != watch->fixed->world_frame) {
    watch->new_objects = prepare(listOf(*watch->fixed));
  }
  if (former) {
    watch->planTakeOver(former);
    constexpr int kTimes = 2;  // the first takes long, and poses go on meanwhile
    for (int i = 0; i < kTimes; ++i) {
      const ros::Time now = ros::Time::now();
      watch->prepare(now, lookAtClock({store_, joints_, clock_}, now));
    }
  }
  return watch;
}

void CycleRunner::replaceWatch(std::unique_ptr<Watch> watch) {
  // Destroyed after the lock is released: memory and topics take long to end.
  std::unique_ptr<Watch> former;
  std::shared_ptr<RobotTopics> known;
  std::unique_lock<std::mutex> lock(mutex_);
  known = topics_;
  lock.unlock();
  auto topics =
      std::make_shared<RobotTopics>(private_node_, watch->fixed->parameters.robots, known.get());
  lock.lock();
  topics_ = std::move(topics);
  current_ = watch->fixed;
  next_ = std::move(watch);
  if (thread_.joinable()) {
    has_next_.notify_one();
    store_.wake();
    taken_over_.wait(lock, [this] { return !next_ && !is_taking_over_; });
  }
  former = std::move(former_);
}

std::shared_ptr<const MonitorSetup> CycleRunner::currentSetup() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return current_;
}

std::optional<PairView> CycleRunner::viewPair(const std::string& link_a,
                                              const std::string& link_b) {
  constexpr std::chrono::seconds kLongest(2);
  auto request = std::make_shared<ViewRequest>();
  request->link_a = link_a;
  request->link_b = link_b;
  std::unique_lock<std::mutex> lock(mutex_);
  view_requests_.push_back(request);
  viewed_.wait_for(lock, kLongest, [&] { return request->view.has_value(); });
  view_requests_.erase(std::remove(view_requests_.begin(), view_requests_.end(), request),
                       view_requests_.end());
  return request->view;
}

/// Marks all requests: this cycle answers them. @return whether there are any
bool CycleRunner::awaitViews() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const std::shared_ptr<ViewRequest>& request : view_requests_) {
    request->is_awaited = true;
  }
  return !view_requests_.empty();
}

/// Verdicts are those of the cycle that has just ended.
void CycleRunner::answerViews() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const std::shared_ptr<ViewRequest>& request : view_requests_) {
    if (request->is_awaited && !request->view) {
      request->view = viewOf(*watch_, request->link_a, request->link_b);
    }
  }
  if (!view_requests_.empty()) {
    viewed_.notify_all();
  }
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
  takeOverSetup();
  pace_.planned_start = SteadyClock::now();
  while (is_running_) {
    pace_.woken = SteadyClock::now();
    runOnce();
    answerViews();
    endCycle();
    waitForNext();
  }
}

void CycleRunner::takeOverSetup() {
  std::unique_ptr<Watch> next;
  std::shared_ptr<RobotTopics> topics;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!next_) {
      return;
    }
    next = std::move(next_);
    topics = topics_;
    is_taking_over_ = true;
  }
  if (watch_) {
    handOver(*watch_, *next);
  }
  watch_.swap(next);
  publishers_.startWatch(*watch_, std::move(topics));
  real_time_.set(watch_->fixed->parameters.real_time_priority);
  statistics_.startWork(watch_->budget);
  pace_.last_state = SteadyClock::time_point();
  const std::lock_guard<std::mutex> lock(mutex_);
  former_ = std::move(next);
  is_taking_over_ = false;
  taken_over_.notify_all();
}

void CycleRunner::handOver(Watch& former, Watch& next) {
  if (!facts_.is_enabled) {
    former.resumeReporting();
  }
  for (const LinkPairIndex pair : next.takeOver(former)) {
    publishers_.publishDropped(former, pair);
  }
  if (!facts_.is_enabled) {
    next.pauseReporting();
  }
}

/// A set-up is taken over only while there is time for it before the next cycle.
void CycleRunner::waitForNext() {
  constexpr std::chrono::microseconds kTakeOver(400);
  takeOverSetup();  // has come in the cycle or shortly before it
  const Parameters& parameters = watch_->fixed->parameters;
  if (parameters.trigger == Trigger::pose) {
    // Waits for news first: if they come no faster than `rate`, no sleep is left.
    store_.waitForNews(seen_data_, endOfWait(parameters, pace_, SteadyClock::now()));
  }
  std::unique_lock<std::mutex> lock(mutex_);
  while (SteadyClock::now() < pace_.planned_start - kTakeOver &&
         has_next_.wait_until(lock, pace_.planned_start - kTakeOver,
                              [this] { return next_ != nullptr; })) {
    lock.unlock();
    takeOverSetup();
    lock.lock();
  }
  lock.unlock();
  std::this_thread::sleep_until(pace_.planned_start);
}

void CycleRunner::runOnce() {
  const SteadyClock::time_point start = SteadyClock::now();
  facts_.now = store_.readTime();
  const bool was_enabled = facts_.is_enabled;
  const ros::SteadyTime steady_now = ros::SteadyTime::now();
  facts_.is_enabled = enabling_.isOn(steady_now);
  facts_.enabled_again_in = enabling_.secondsUntilOn(steady_now);
  facts_.muted_for = watch_->mutedFor(start);
  bool is_new = readPoses(facts_.now);
  if (facts_.is_enabled != was_enabled) {
    log_.warn(std::string("the monitor is switched ") + (facts_.is_enabled ? "on" : "off"));
    if (facts_.is_enabled) {
      watch_->resumeReporting();
    } else {
      watch_->pauseReporting();
    }
    is_new = true;
  }
  publishers_.askWhoListens(steady_now);
  watch_->buffers.refine.tells_all = awaitViews() || publishers_.tellsAll();
  watch_->cycle();
  ++facts_.cycles;
  countStep(watch_->buffers.sweep, facts_.steps);
  facts_.cycle_time = std::chrono::duration<double>(SteadyClock::now() - start).count();
  publish(is_new);
}

/// Counts the cycle if it is late, and plans the next one. Whatever follows makes that one late.
void CycleRunner::endCycle() {
  const Parameters& parameters = watch_->fixed->parameters;
  const SteadyClock::time_point now = SteadyClock::now();
  const bool is_overrun = now > endOfCycle(parameters, pace_);
  pace_.planned_start = nextStart(parameters, pace_, now);
  real_time_.add(is_overrun);
  network_priority_.set(std::max(0, real_time_.priority() - 1));  // cycles come first
  facts_.overruns += is_overrun ? 1 : 0;
  statistics_.addCycle(facts_.cycle_time, is_overrun, real_time_.state());
  statistics_.addWork(watch_->buffers, facts_.cycle_time, watch_->budget);
}

/// @return true if anything differs from the last cycle.
bool CycleRunner::readPoses(const ros::Time& now) {
  const TransformStore::Version version = store_.version();
  seen_data_ = version.data;
  if (version.jumps != seen_jumps_) {
    seen_jumps_ = version.jumps;
    joints_.forget();
    watch_->forget();
    const std::string sentence = jumps_.tell(SteadyClock::now());
    if (!sentence.empty()) {
      log_.warn(sentence);
    }
  }
  return watch_->read(now, lookAtClock({store_, joints_, clock_}, now));
}

void CycleRunner::publish(bool is_new) {
  const Watch& watch = *watch_;
  publishers_.publishMarkers();
  if (facts_.is_enabled) {
    publishers_.publishChanges(watch);
  }
  const SteadyClock::time_point now = SteadyClock::now();
  const std::uint8_t level = levelOf(watch, facts_);
  const bool is_due = isStateDue(watch.fixed->parameters, pace_, now);
  if (!is_new && !is_due && level == last_level_) {
    publishers_.drawMarkers(watch, false);
    return;
  }
  last_level_ = level;
  pace_.last_state = now;
  const State& state = publishers_.publishCycle(watch, facts_);
  publishers_.drawMarkers(watch, true);
  constexpr std::chrono::milliseconds kSummaryPeriod(200);
  if (now - last_summary_ >= kSummaryPeriod) {
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
  summary.refused = store_.refusedTooMany() + joints_.refusedTooLong();
  summary.unknown_links = state.unknown_links;
  summary.robots = state.robots;
  summary.muted = state.pairs_muted;
  summary.muted_for = state.muted_for;
  statistics_.setSummary(std::move(summary));
}

}  // namespace collision_monitor
