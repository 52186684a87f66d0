// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/check_states.h"

#include <collision_monitor/LinkDistance.h>
#include <collision_monitor/State.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/pipeline/check_states.h"
#include "ros_edge/apply_joints.h"

namespace collision_monitor {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// The number of states; a sentence for each thing that is wrong.
std::size_t countStates(const RobotModel& model, const CheckStates::Request& request,
                        std::vector<std::string>& faults) {
  sensor_msgs::JointState names;
  names.name = request.joint_names;
  names.position.resize(names.name.size(), 0.0);
  faults = jointFaults(model, names);
  const std::size_t joints = request.joint_names.size();
  if (model.variable_count == 0 && joints == 0 && request.positions.empty()) {
    return 1;  // nothing moves: the one state there is
  }
  if (joints == 0) {
    faults.emplace_back("joint_names is empty; name the joints that move");
    return 0;
  }
  if (request.positions.empty() || request.positions.size() % joints != 0) {
    faults.push_back("positions has " + std::to_string(request.positions.size()) + " values for " +
                     std::to_string(joints) + " joints; give one for each joint of each state");
  }
  return faults.empty() ? request.positions.size() / joints : 0;
}

/// By variable: its place in a state of the request, or -1.
std::vector<int> placesOf(const RobotModel& model, const std::vector<std::string>& joint_names) {
  std::vector<int> places(model.variable_count, -1);
  for (std::size_t i = 0; i < joint_names.size(); ++i) {
    const Joint& joint = model.joint(*model.findJoint(joint_names[i]));
    // The value of a mimic joint follows from that of its source.
    if (!joint.mimic) {
      places[joint.first_variable] = static_cast<int>(i);
    }
  }
  return places;
}

/// NaN where a number means nothing: the state is unknown then.
JointPositions positionsOf(const CheckStates::Request& request, const std::vector<int>& places,
                           std::size_t count) {
  JointPositions positions;
  positions.reserve(count * places.size());
  for (std::size_t state = 0; state < count; ++state) {
    const double* first = request.positions.data() + state * request.joint_names.size();
    for (const int place : places) {
      const double position = place < 0 ? 0.0 : first[place];
      positions.push_back(std::abs(position) <= kFarthest ? position : kNotANumber);
    }
  }
  return positions;
}

void addCheck(const CycleSetup& setup, const StateCheck& check, CheckStates::Response& response) {
  response.levels.push_back(static_cast<std::uint8_t>(check.verdict));
  response.distances.push_back(check.has_pair ? check.distance : kNotANumber);
  response.qualities.push_back(
      static_cast<std::uint8_t>(check.has_pair ? check.quality : Quality::unknown));
  response.links_a.emplace_back();
  response.links_b.emplace_back();
  if (check.has_pair) {
    const CheckedLinkPair& pair = setup.checked[setup.link_pair_of[index(check.pair)]];
    response.links_a.back() = setup.model.link(pair.a).name;
    response.links_b.back() = setup.model.link(pair.b).name;
  }
}

std::string summaryText(const CheckStates::Response& response) {
  const auto count = [&](std::uint8_t level) {
    return std::to_string(std::count(response.levels.begin(), response.levels.end(), level));
  };
  return std::to_string(response.levels.size()) + " states: " + count(State::CONTACT) +
         " in contact, " + count(State::UNKNOWN) + " unknown";
}

}  // namespace

void answerCheckStates(const MonitorSetup& current, const LinkPoses& newest,
                       const CheckStates::Request& request, CheckStates::Response& response) {
  const CycleSetup& setup = current.setup;
  std::vector<std::string> faults;
  const std::size_t count = countStates(setup.model, request, faults);
  response.success = faults.empty() ? 1 : 0;
  if (!faults.empty()) {
    for (const std::string& fault : faults) {
      response.message += (response.message.empty() ? "" : "; ") + fault;
    }
    return;
  }
  const std::vector<int> places = placesOf(setup.model, request.joint_names);
  std::vector<bool> moves(places.size());
  std::transform(places.begin(), places.end(), moves.begin(), [](int place) { return place >= 0; });
  StatesWork work = makeStatesWork(setup, standingAs(setup.model, newest, moves));
  const JointPositions positions = positionsOf(request, places, count);
  const StateQuestion question =
      request.only_contacts != 0 ? StateQuestion::contact : StateQuestion::nearest;
  std::vector<StateCheck> checks;
  (request.enclosing_shapes != 0 ? checkStates : checkStatesExactly)(setup, positions, question,
                                                                     work, checks);
  for (const StateCheck& check : checks) {
    addCheck(setup, check, response);
  }
  response.message = summaryText(response);
}

}  // namespace collision_monitor
