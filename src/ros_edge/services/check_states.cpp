// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/check_states.h"

#include <collision_monitor/LinkDistance.h>
#include <collision_monitor/State.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/place.h"
#include "pipeline/states/check_states.h"
#include "ros_edge/outputs/sentences.h"
#include "ros_edge/poses/apply_joints.h"
#include "ros_edge/poses/floating_parts.h"
#include "ros_edge/robots/missing.h"

namespace collision_monitor {
namespace {

/// Half a minute for arms whose meshes are near in every state, and some 20 MB. Larger calls are no
/// more efficient, and other calls wait for their end.
constexpr std::size_t kMostStates = 100'000;
/// Tenths of a second at most: the delay until a call can give up.
constexpr std::size_t kStatesAtOnce = 1000;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// The number of states. Adds a sentence for each fault of the request.
std::size_t countStates(const RobotModel& model, const CheckStates::Request& request,
                        std::vector<std::string>& faults) {
  sensor_msgs::JointState names;
  names.name = request.joint_names;
  names.position.resize(names.name.size(), 0.0);
  faults = jointFaults(model, names, "joint_names");
  const std::size_t joints = request.joint_names.size();
  if (joints == 0 && !takesPositions(model)) {
    if (!request.positions.empty()) {
      faults.push_back("positions has " + counted(request.positions.size(), "value") +
                       ", but no joint of this robot can be given; leave it empty");
    }
    return faults.empty() ? 1 : 0;
  }
  if (joints == 0) {
    faults.emplace_back("joint_names is empty; name the joints that move");
    return 0;
  }
  if (request.positions.empty() || request.positions.size() % joints != 0) {
    faults.push_back("positions has " + counted(request.positions.size(), "value") + " for " +
                     counted(joints, "joint") + "; give one for each joint of each state");
  } else if (request.positions.size() / joints > kMostStates) {
    faults.push_back("positions has " + std::to_string(request.positions.size() / joints) +
                     " states; give at most " + std::to_string(kMostStates) + " in one call");
  }
  return faults.empty() ? request.positions.size() / joints : 0;
}

/// By variable: its index in a state of the request, or -1.
std::vector<int> placesOf(const RobotModel& model, const std::vector<std::string>& joint_names) {
  std::vector<int> places(model.variable_count, -1);
  for (std::size_t i = 0; i < joint_names.size(); ++i) {
    const Joint& joint = model.joint(*model.findJoint(joint_names[i]));
    // A mimic joint follows its source, whatever its own value is.
    if (!joint.mimic) {
      places[joint.first_variable] = static_cast<int>(i);
    }
  }
  return places;
}

/// The states of a request without faults.
struct AskedStates {
  const CheckStates::Request& request;
  std::size_t count;
  std::vector<int> places;  ///< as placesOf
};

struct StateRange {
  std::size_t first;
  std::size_t last;  ///< one past the end
};

/// States of which a number is not finite or beyond 1e9.
struct InvalidStates {
  std::size_t count{0};
  std::size_t first{0};  ///< the first such number in CheckStates::Request::positions
};

bool isValid(double position) { return std::abs(position) <= kFarthest; }

/// NaN if a number of the state is invalid: the state is then unknown.
void positionsOf(const AskedStates& asked, const StateRange& range, JointPositions& positions,
                 InvalidStates& invalid) {
  positions.clear();
  const std::vector<double>& numbers = asked.request.positions;
  const std::size_t joints = asked.request.joint_names.size();
  for (std::size_t state = range.first; state < range.last; ++state) {
    const double* first = numbers.data() + state * joints;
    const double* const fault = std::find_if_not(first, first + joints, isValid);
    const bool is_valid = fault == first + joints;
    if (!is_valid && invalid.count++ == 0) {
      invalid.first = static_cast<std::size_t>(fault - numbers.data());
    }
    for (const int place : asked.places) {
      positions.push_back(is_valid ? (place < 0 ? 0.0 : first[place]) : kNotANumber);
    }
  }
}

/// "; positions[3], of joint 'elbow' in state 1, is nan; accepted: -1e9 to 1e9; 4 more such
/// states"; empty if there are none.
std::string invalidText(const CheckStates::Request& request, const InvalidStates& invalid) {
  if (invalid.count == 0) {
    return "";
  }
  const std::size_t joints = request.joint_names.size();
  const std::string more = invalid.count == 1
                               ? ""
                               : "; " + std::to_string(invalid.count - 1) + " more such " +
                                     (invalid.count == 2 ? "state" : "states");
  return "; positions[" + std::to_string(invalid.first) + "], of joint " +
         quoted(request.joint_names[invalid.first % joints]) + " in state " +
         std::to_string(invalid.first / joints) + ", " +
         numberFault(request.positions[invalid.first]) + more;
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
  return counted(response.levels.size(), "state") + ": " + count(State::CONTACT) + " in contact, " +
         count(State::UNKNOWN) + " unknown";
}

/// Judges all states. @return false if `progress` gave up; then the response says so
bool judgeAll(const CycleSetup& setup, const AskedStates& asked,
              const std::function<bool(double)>& progress, StatesWork& work, InvalidStates& invalid,
              CheckStates::Response& response) {
  const StateQuestion question =
      asked.request.only_contacts != 0 ? StateQuestion::contact : StateQuestion::nearest;
  const auto check = asked.request.enclosing_shapes != 0 ? checkStates : checkStatesExactly;
  const std::size_t count = asked.count;
  JointPositions positions;
  std::vector<StateCheck> checks;
  for (std::size_t first = 0; first < count; first += kStatesAtOnce) {
    const std::size_t last = std::min(count, first + kStatesAtOnce);
    positionsOf(asked, {first, last}, positions, invalid);
    check(setup, positions, question, work, checks);
    for (const StateCheck& one : checks) {
      addCheck(setup, one, response);
    }
    if (progress && !progress(static_cast<double>(last) / static_cast<double>(count))) {
      response = CheckStates::Response();
      response.message = "given up after " + std::to_string(last) + " of " + std::to_string(count) +
                         " states: the monitor ends";
      return false;
    }
  }
  return true;
}

}  // namespace

void answerCheckStates(const MonitorSetup& current, const NewestState& newest,
                       const std::function<bool(double)>& progress,
                       const CheckStates::Request& request, CheckStates::Response& response) {
  const CycleSetup& setup = current.setup;
  std::vector<std::string> faults;
  const std::size_t count = countStates(setup.model, request, faults);
  response.success = faults.empty() ? 1 : 0;
  if (!faults.empty()) {
    response.message = join(faults);
    return;
  }
  const AskedStates asked{request, count, placesOf(setup.model, request.joint_names)};
  std::vector<bool> moves(asked.places.size());
  std::transform(asked.places.begin(), asked.places.end(), moves.begin(),
                 [](int place) { return place >= 0; });
  StatesWork work = makeStatesWork(setup, standingAs(setup.model, newest.poses, moves));
  InvalidStates invalid;
  if (!judgeAll(setup, asked, progress, work, invalid, response)) {
    return;
  }
  const std::string missing = missingSentence(current);
  for (std::uint8_t& level : response.levels) {
    level = missing.empty() ? level : std::max<std::uint8_t>(level, State::UNKNOWN);
  }
  const std::string floating =
      floatingPartsText(setup.model, work.poses, setup.checked, newest.reasons);
  response.message = summaryText(response) + invalidText(request, invalid) +
                     (missing.empty() ? "" : "; " + missing) +
                     (floating.empty() ? "" : "; " + floating);
}

}  // namespace collision_monitor
