// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/late_robots.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "collision_monitor/model/problems.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

std::vector<std::string> textsOf(const LoadedRobots& robots) {
  std::vector<std::string> texts;
  for (const RobotDescription& robot : robots.descriptions) {
    texts.push_back(robot.urdf_xml);
    texts.push_back(robot.srdf_xml);
  }
  return texts;
}

/// The first fault, for a sentence.
std::string shortFault(const std::exception& fault) {
  const auto* error = dynamic_cast<const SetupError*>(&fault);
  return error == nullptr || error->problems().empty() ? failureText(fault)
                                                       : toString(error->problems().front());
}

}  // namespace

LateRobots::LateRobots(LateHooks hooks) : hooks_(std::move(hooks)) {}

void LateRobots::look() {
  try {
    const Interruptible interruptible(hooks_.goes_on);
    const std::shared_ptr<const MonitorSetup> current = hooks_.current_setup();
    if (isAnyMissing(*current)) {
      lookAt(current);
    }
  } catch (const std::exception& fault) {
    noteFault(fault);
  } catch (const Interrupted&) {
    // The monitor ends.
  }
}

void LateRobots::lookAt(const std::shared_ptr<const MonitorSetup>& current) {
  SetupReport report;
  LoadedRobots come = hooks_.find(*current, std::nullopt, report);
  const std::vector<ListedRobot> listed = come.listed;
  if (come.descriptions.size() == current->descriptions.size()) {
    last_ = Attempt();
    own_faults_.clear();
    tell(listed, *current);
    return;
  }
  const std::shared_ptr<const MonitorSetup> built = last_.late;
  try {
    attempt(std::move(come), report, current);
  } catch (const std::exception& fault) {
    noteFault(fault);
    const bool is_built = last_.late == nullptr || last_.late != built;
    if (is_built && takeInOne(listed, *current)) {
      return;  // the next look tries those that are left
    }
  }
  if (!last_.fault.empty()) {
    tell(listed, *current);
  }
}

void LateRobots::attempt(LoadedRobots come, SetupReport& report,
                         const std::shared_ptr<const MonitorSetup>& current) {
  constexpr std::chrono::seconds kLongestWait(60);
  std::vector<std::string> texts = textsOf(come);
  const bool is_other = texts != last_.texts || current->robots != last_.beside;
  if (is_other || Clock::now() >= last_.again_at) {
    const std::chrono::seconds wait =
        is_other ? Attempt().wait : std::min(2 * last_.wait, kLongestWait);
    last_ = {current->robots, std::move(texts), nullptr, nullptr, "", wait, Clock::time_point()};
    last_.late = hooks_.build(std::move(come), *current, report);
  } else if (last_.late == nullptr || last_.refused_by == current) {
    return;
  }
  last_.refused_by = current;
  hooks_.take_in(*last_.late, *current);
  last_ = Attempt();
  logged_.clear();
}

/// One robot's fault keeps no other away.
/// @return whether one was taken in, of several that have come
bool LateRobots::takeInOne(const std::vector<ListedRobot>& come, const MonitorSetup& current) {
  own_faults_.clear();
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < come.size(); ++i) {
    if (come[i].id && !current.listed[i].id) {
      places.push_back(i);
    }
  }
  for (std::size_t i = 0; places.size() > 1 && i < places.size(); ++i) {
    try {
      SetupReport report;
      hooks_.take_in(*hooks_.build(hooks_.find(current, places[i], report), current, report),
                     current);
      return true;
    } catch (const std::exception& fault) {
      own_faults_[places[i]] = shortFault(fault);
    }
  }
  return false;
}

void LateRobots::noteFault(const std::exception& fault) {
  last_.fault = shortFault(fault);
  last_.again_at = Clock::now() + last_.wait;
  const std::string text = failureText(fault);
  if (text != logged_) {
    logged_ = text;
    hooks_.log_error(
        "a robot that has come cannot be taken in; the others are watched as before: " + text);
  }
}

/// State tells what is missing, and what is wrong with robots that have come.
void LateRobots::tell(std::vector<ListedRobot> come, const MonitorSetup& current) const {
  bool is_new = false;
  for (std::size_t i = 0; i < come.size(); ++i) {
    const ListedRobot& known = current.listed[i];
    ListedRobot& robot = come[i];
    robot.has_come = robot.id && !known.id;
    if (robot.has_come) {
      const auto own = own_faults_.find(i);
      robot.missing = "its URDF has come, but it cannot be taken in: " +
                      (own == own_faults_.end() ? last_.fault : own->second);
    }
    is_new = is_new || robot.missing != known.missing;
  }
  if (is_new) {
    hooks_.tell_missing(current, come);
  }
}

}  // namespace collision_monitor
