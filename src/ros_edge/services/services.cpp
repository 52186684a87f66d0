// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/services.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "model/number_text.h"
#include "ros_edge/outputs/sentences.h"
#include "ros_edge/parameters/resource_loader.h"
#include "ros_edge/parameters/startup_report.h"
#include "ros_edge/services/change_rules.h"
#include "ros_edge/services/check_states.h"
#include "ros_edge/services/check_trajectory.h"
#include "ros_edge/services/get_distances.h"
#include "ros_edge/watch.h"

namespace collision_monitor {

Services::Services(const ros::NodeHandle& private_node, const Inputs& inputs, ServiceHooks hooks,
                   LogThread& log)
    : private_node_(private_node),
      inputs_(inputs),
      hooks_(std::move(hooks)),
      log_(log),
      quick_(2, 0, hooks_.network_priority),
      changes_(2, 0, hooks_.network_priority),
      background_(1, 10, hooks_.network_priority),
      objects_(private_node, inputs,
               {hooks_.current_setup, hooks_.change_setup, [this] { return goesOn(); }}, locks_,
               quick_, changes_),
      rule_clock_([this] { return nextEndOf(*hooks_.current_setup()); }, [this] { endRules(); },
                  log),
      late_robots_(lateHooks()),
      late_look_(std::chrono::milliseconds(500), [this] { late_robots_.look(); }) {
  const auto serve = [&](ServiceQueue& queue, const char* name, auto answer) {
    servers_.push_back(queue.serve(private_node_, name, answer, this));
  };
  serve(background_, "check_trajectory", &Services::checkTrajectory);
  serve(background_, "check_states", &Services::checkStates);
  serve(quick_, "get_distances", &Services::getDistances);
  serve(quick_, "explain_pair", &Services::explainPair);
  serve(changes_, "set_pairs", &Services::setPairs);
  serve(changes_, "set_limits", &Services::setLimits);
  serve(quick_, "set_enabled", &Services::setEnabled);
  serve(changes_, "reload", &Services::reload);
}

/// Servers wait for their current call when they end.
Services::~Services() { background_.end(); }

/// Whether a long call may continue.
bool Services::goesOn() const { return hooks_.goes_on() && !background_.isEnding(); }

NewestState Services::newestState(const MonitorSetup& current) const {
  const RobotModel& model = current.setup.model;
  NewestState newest = makeNewestState(model);
  const ros::Time now = ros::Time::now();
  if (now.isZero()) {
    std::fill(newest.reasons.begin(), newest.reasons.end(),
              clockSentence({ClockFault::not_started, 0.0}));
    return newest;
  }
  const ClockState clock = lookAtClock(inputs_, now);
  JointReader joints(model, inputs_.joints, jointTopics(current));
  PoseReader reader = makePoseReader(current, inputs_.transforms, joints);
  reader.read(now, newest.poses);
  if (clock.fault != ClockFault::none) {
    growStale(newest.poses);
    std::fill(newest.reasons.begin(), newest.reasons.end(), clockSentence(clock));
    return newest;
  }
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    newest.reasons[i] = newest.poses.part[i] == i ? reader.explain(idAt<LinkId>(i)) : "";
  }
  joints.refresh();
  joints.readNewestPositions(now, current.parameters.max_age, newest.positions);
  return newest;
}

bool Services::getDistances(GetDistances::Request& request, GetDistances::Response& response) {
  const std::shared_ptr<const MonitorSetup> current = hooks_.current_setup();
  answerGetDistances(*current, newestState(*current), request, response);
  return true;
}

std::function<bool(double)> Services::tellProgress(const char* call) const {
  static constexpr std::chrono::seconds kBetween(2);
  return [this, call, last = std::chrono::steady_clock::now()](double done) mutable {
    const auto now = std::chrono::steady_clock::now();
    if (now - last >= kBetween) {
      last = now;
      log_.info(std::string(call) + ": " + std::to_string(std::lround(100.0 * done)) +
                " % checked");
    }
    return goesOn();
  };
}

bool Services::checkTrajectory(CheckTrajectory::Request& request,
                               CheckTrajectory::Response& response) {
  const std::shared_ptr<const MonitorSetup> current = hooks_.current_setup();
  const auto tell = tellProgress("check_trajectory");
  answerCheckTrajectory(*current, newestState(*current), tell, request, response);
  return true;
}

bool Services::checkStates(CheckStates::Request& request, CheckStates::Response& response) {
  const std::shared_ptr<const MonitorSetup> current = hooks_.current_setup();
  const auto tell = tellProgress("check_states");
  answerCheckStates(*current, newestState(*current), tell, request, response);
  return true;
}

bool Services::explainPair(ExplainPair::Request& request, ExplainPair::Response& response) {
  const std::shared_ptr<const MonitorSetup> current = hooks_.current_setup();
  answerExplainPair(*current, newestState(*current), hooks_.view_pair, request, response);
  return true;
}

bool Services::setPairs(SetPairs::Request& request, SetPairs::Response& response) {
  const auto lock = locks_.beginChange();
  if (!lock) {
    response.message = kOtherChange;
    return true;
  }
  const std::lock_guard<std::mutex> swap(locks_.swap);
  const NextSetup next = answerSetPairs(*hooks_.current_setup(), std::chrono::steady_clock::now(),
                                        ++requests_, request, response);
  if (next) {
    hooks_.change_setup(next);
    rule_clock_.wake();
    log_.info("set_pairs: " + response.message);
  }
  return true;
}

bool Services::setLimits(SetLimits::Request& request, SetLimits::Response& response) {
  const auto lock = locks_.beginChange();
  if (!lock) {
    response.message = kOtherChange;
    return true;
  }
  const std::lock_guard<std::mutex> swap(locks_.swap);
  if (const NextSetup next = answerSetLimits(*hooks_.current_setup(), request, response)) {
    hooks_.change_setup(next);
    log_.info("set_limits: " + response.message);
  }
  return true;
}

void Services::endRules() {
  const std::lock_guard<std::mutex> swap(locks_.swap);
  std::vector<Problem> dropped_limits;
  const NextSetup next =
      withoutEnded(*hooks_.current_setup(), std::chrono::steady_clock::now(), dropped_limits);
  if (next) {
    next->later_warnings->add(dropped_limits);
    hooks_.change_setup(next);
    for (const Problem& warning : dropped_limits) {
      log_.warn(toString(warning));
    }
    log_.info("rules for pairs have ended; left: " + std::to_string(next->setup.pair_rules.size()));
  }
}

LateHooks Services::lateHooks() {
  LateHooks hooks;
  hooks.current_setup = hooks_.current_setup;
  hooks.find = [this](const MonitorSetup& former, std::optional<std::size_t> only,
                      SetupReport& report) {
    const ResourceLoader load_resource = makeResourceLoader(former.parameters.loading);
    return loadLate(private_node_, former.parameters, load_resource,
                    {former.descriptions, former.listed}, only, report);
  };
  hooks.build = buildLate;
  hooks.take_in = [this](const MonitorSetup& late, const MonitorSetup& former) {
    takeInLate(late, former);
  };
  hooks.tell_missing = [this](const MonitorSetup& former, const auto& listed) {
    tellMissing(former, listed);
  };
  hooks.log_error = [this](const std::string& text) { log_.error(text); };
  hooks.goes_on = [this] { return goesOn(); };
  return hooks;
}

/// Changes of objects, rules and limits may have come since the robots were built; after a reload
/// they are built again.
void Services::takeInLate(const MonitorSetup& late, const MonitorSetup& former) {
  const std::lock_guard<std::timed_mutex> lock(locks_.change);
  const std::lock_guard<std::mutex> swap(locks_.swap);
  const std::shared_ptr<const MonitorSetup> current = hooks_.current_setup();
  if (current->robots != former.robots) {
    return;
  }
  const std::shared_ptr<const MonitorSetup> made = takeIn(late, *current);
  hooks_.replace_setup(made);
  rule_clock_.wake();
  for (std::size_t i = 0; i < made->listed.size(); ++i) {
    if (made->listed[i].id && !former.listed[i].id) {
      log_.info("robot '" + made->listed[i].name + "' has come late and is watched from now on");
    }
  }
  logSetup(*made, log_);
}

void Services::tellMissing(const MonitorSetup& former, const std::vector<ListedRobot>& listed) {
  const std::lock_guard<std::timed_mutex> lock(locks_.change);
  const std::lock_guard<std::mutex> swap(locks_.swap);
  const std::shared_ptr<const MonitorSetup> current = hooks_.current_setup();
  if (current->robots == former.robots) {
    hooks_.change_setup(withMissing(*current, listed));
  }
}

bool Services::setEnabled(std_srvs::SetBool::Request& request,
                          std_srvs::SetBool::Response& response) {
  const bool is_enabled = request.data != 0;
  hooks_.set_enabled(is_enabled);
  response.success = 1;
  const std::string seconds = shortText(hooks_.current_setup()->parameters.disable_timeout);
  response.message = is_enabled ? "switched on"
                                : "switched off; switches itself on again in " + seconds +
                                      " s (parameter disable_timeout)";
  return true;
}

bool Services::reload(std_srvs::Trigger::Request& /*request*/,
                      std_srvs::Trigger::Response& response) {
  const auto lock = locks_.beginChange();
  response.success = 0;
  if (!lock) {
    response.message = kOtherChange;
    return true;
  }
  try {
    const std::shared_ptr<const MonitorSetup> former = hooks_.current_setup();
    const std::shared_ptr<const MonitorSetup> made = makeMonitorSetup(
        private_node_, [this] { return goesOn(); }, former.get());
    const std::lock_guard<std::mutex> swap(locks_.swap);  // only now: meanwhile mutes end
    hooks_.replace_setup(made);
    rule_clock_.wake();
    logSetup(*made, log_);
    response.message = summaryOf(*made);
    response.success = 1;
  } catch (const std::exception& error) {
    response.message = "nothing was changed: " + failureText(error);
  } catch (const Interrupted&) {
    response.message = "nothing was changed: the monitor ends";
  }
  return true;
}

}  // namespace collision_monitor
