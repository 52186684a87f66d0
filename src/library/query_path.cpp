// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "library/query_parts.h"
#include "model/few_texts.h"
#include "model/number_text.h"
#include "model/place.h"
#include "pipeline/trajectory/check_trajectory.h"

namespace collision_monitor {
namespace {

/// Whether a path may move the joint.
bool moves(const Joint& joint) { return !joint.mimic && freedomOf(joint) == 1; }

std::string numbersText(const char* name, std::size_t size) {
  return "`" + std::string(name) + "` has " + counted(size, "number");
}

/// Adds faults of sizes. @return the number of way-points, 0 after a fault
std::size_t checkSizes(const WayPoints& path, std::size_t n, FewTexts& faults) {
  const std::size_t count = n == 0 ? path.times.size() : path.positions.size() / n;
  if (count == 0 || path.positions.size() != count * n) {
    faults.add([&] {
      return numbersText("positions", path.positions.size()) + "; accepted: " + std::to_string(n) +
             " for each way-point, and at least one way-point";
    });
    return 0;
  }
  if (path.times.size() != 0 && path.times.size() != count) {
    faults.add([&] {
      return numbersText("times", path.times.size()) + " for " + counted(count, "way-point") +
             "; accepted: one for each, or none";
    });
  }
  if (path.velocities.size() != 0 && path.velocities.size() != path.positions.size()) {
    faults.add([&] {
      return numbersText("velocities", path.velocities.size()) + ", `positions` " +
             std::to_string(path.positions.size()) + "; accepted: as many, or none";
    });
  }
  return faults.all().empty() ? count : 0;
}

void checkTimes(Numbers times, FewTexts& faults) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool is_later = i == 0 || times[i] > times[i - 1];
    if (!is_later || !std::isfinite(times[i])) {
      faults.add([&] {
        return "times[" + std::to_string(i) + "] is " + shortText(times[i]) +
               " s; accepted: finite numbers that increase";
      });
    }
  }
}

/// Planar and floating joints must stay where they are.
void checkHeld(const RobotModel& model, const WayPoints& path, FewTexts& faults) {
  const std::size_t n = model.variable_count;
  const auto stays = [&](std::size_t variable) {
    for (std::size_t i = variable; i < path.positions.size(); i += n) {
      const double first = path.positions[variable];
      if (path.positions[i] != first && !(std::isnan(first) && std::isnan(path.positions[i]))) {
        return false;
      }
    }
    return true;
  };
  for (const Joint& joint : model.joints) {
    const std::size_t variables = joint.type == JointType::floating ? 7 : freedomOf(joint);
    for (std::size_t k = 0; !joint.mimic && variables > 1 && k < variables; ++k) {
      if (!stays(joint.first_variable + k)) {
        faults.add([&] {
          return "joint '" + joint.name +
                 "' is planar or floating and moves; a path can only keep it where it is";
        });
      }
    }
  }
}

/// Velocities are numbers like positions; cubics must not swing beyond what positions may be.
/// @pre times and sizes have no faults
void checkVelocities(const WayPoints& path, const std::vector<double>& times, std::size_t n,
                     FewTexts& faults) {
  double longest = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    longest = std::max(longest, times[i] - times[i - 1]);
  }
  for (std::size_t i = 0; i < path.velocities.size(); ++i) {
    const double velocity = path.velocities[i];
    if (!(std::abs(velocity) * std::max(1.0, longest) <= kFarthest)) {
      faults.add([&] {
        return "velocities[" + std::to_string(i / n) + "][" + std::to_string(i % n) + "] is " +
               shortText(velocity) + "; accepted: up to 1e9 within the time between way-points";
      });
    }
  }
}

std::vector<double> timesOf(const WayPoints& path, std::size_t count) {
  std::vector<double> times(path.times.begin(), path.times.end());
  while (times.size() < count) {
    times.push_back(static_cast<double>(times.size()));
  }
  return times;
}

/// @throws ArgumentError
JointPath readPath(const RobotModel& model, const WayPoints& way_points) {
  const std::size_t n = model.variable_count;
  FewTexts faults;
  JointPath path;
  const std::size_t count = checkSizes(way_points, n, faults);
  if (count != 0) {
    checkTimes(way_points.times, faults);
    checkHeld(model, way_points, faults);
    path.times = timesOf(way_points, count);
    checkVelocities(way_points, path.times, n, faults);
  }
  if (std::vector<std::string> texts = faults.all(); !texts.empty()) {
    throw ArgumentError(std::move(texts));
  }
  JointPositions positions;
  readPositions(way_points.positions, positions);
  std::vector<std::size_t> variables;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    if (moves(model.joints[i])) {
      path.joints.push_back(idAt<JointId>(i));
      variables.push_back(model.joints[i].first_variable);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::size_t variable : variables) {
      path.positions.push_back(positions[i * n + variable]);
      if (way_points.velocities.size() != 0) {
        path.velocities.push_back(way_points.velocities[i * n + variable]);
      }
    }
  }
  return path;
}

void checkOptions(const TrajectoryOptions& options) {
  std::vector<std::string> faults;
  if (!std::isfinite(options.margin)) {
    faults.emplace_back("`margin` is not finite; give metres");
  }
  if (!(options.resolution > 0.0) || !std::isfinite(options.resolution)) {
    faults.push_back("`resolution` is " + shortText(options.resolution) +
                     "; accepted: finite and above 0 m");
  }
  if (!(options.tolerance > 0.0) || !std::isfinite(options.tolerance)) {
    faults.push_back("`tolerance` is " + shortText(options.tolerance) +
                     "; accepted: finite and above 0 m");
  }
  if (!faults.empty()) {
    throw ArgumentError(std::move(faults));
  }
}

PairOnPath answerOf(const CycleSetup& setup, LinkPairIndex pair, const PairApproach& approach) {
  PairOnPath answer;
  answer.state = approach.state;
  if (approach.state == ApproachState::unknown) {
    answer.time = answer.at_least = kUnknown;
    answer.nearest = unknownPair(pair);
    return answer;
  }
  answer.time = approach.time;
  answer.at_least = approach.at_least;
  answer.nearest = std::isfinite(approach.nearest.measured.distance)
                       ? measuredPair(setup, approach.nearest, verdictOf(setup, approach.nearest))
                       : unknownPair(pair);  // given up before any measurement
  return answer;
}

}  // namespace

PathAnswer RobotQuery::checkPath(const WayPoints& way_points, const TrajectoryOptions& options) {
  const CycleSetup& setup = parts_->setup;
  checkOptions(options);
  const JointPath path = readPath(setup.model, way_points);
  const Numbers first(way_points.positions.data(), setup.model.variable_count);
  linkPoses(first);
  const TrajectoryReport report = checkTrajectory(setup, path, parts_->poses, options);
  PathAnswer answer;
  for (LinkPairIndex i = 0; i < report.pairs.size(); ++i) {
    answer.pairs.push_back(answerOf(setup, i, report.pairs[i]));
  }
  answer.first_contact = report.first_contact;
  answer.verdict = verdictOf(report, options);
  return answer;
}

}  // namespace collision_monitor
