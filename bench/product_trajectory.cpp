// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <random>

#include "collision_monitor/pipeline/check_trajectory.h"
#include "product_bench.h"
#include "robot_moves.h"
#include "thread_time.h"

namespace collision_monitor::test {
namespace {

/// All joints that move go evenly from one random configuration to the next, and to two more: 100
/// way-points a tenth of a second apart.
JointPath makePath(const RobotModel& model) {
  constexpr std::size_t kWaypoints = 100;
  constexpr std::size_t kPartWaypoints = 25;
  JointPath path;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    if (isDrawn(model.joints[i])) {
      path.joints.push_back(idAt<JointId>(i));
    }
  }
  std::mt19937_64 random(20260101);
  JointPositions from = drawPositions(model, random);
  JointPositions to = drawPositions(model, random);
  for (std::size_t k = 0; k < kWaypoints; ++k) {
    path.times.push_back(0.1 * static_cast<double>(k));
    if (k > 0 && k % kPartWaypoints == 0) {
      from = to;
      to = drawPositions(model, random);
    }
    const double share = static_cast<double>(k % kPartWaypoints) / kPartWaypoints;
    const JointPositions positions = between(from, to, share);
    for (const JointId joint : path.joints) {
      path.positions.push_back(positions[model.joint(joint).first_variable]);
    }
  }
  return path;
}

void printPairs(const TrajectoryReport& report) {
  const auto count_of = [&](ApproachState state) {
    return static_cast<std::size_t>(
        std::count_if(report.pairs.begin(), report.pairs.end(),
                      [&](const PairApproach& pair) { return pair.state == state; }));
  };
  print("trajectory_contacts", count_of(ApproachState::contact));
  print("trajectory_undecided",
        count_of(ApproachState::undecided) + count_of(ApproachState::unknown));
}

}  // namespace

void measureTrajectory(const CycleSetup& setup) {
  constexpr int kCalls = 5;
  const JointPath path = makePath(setup.model);
  const LinkPoses start = posesAt(setup.model, defaultPositions(setup.model));
  const TrajectoryOptions options;
  TrajectoryOptions contacts_only;
  contacts_only.margin = 0.0;
  TrajectoryReport report;
  const auto time = [&](const char* name, const TrajectoryOptions& asked) {
    print(name,
          1e-6 * medianTimeOf(kCalls, [&] { report = checkTrajectory(setup, path, start, asked); }),
          "ms");
  };
  print("trajectory_joints", path.joints.size());
  time("trajectory_contacts_only", contacts_only);
  time("trajectory_nearest", options);
  printPairs(report);
}

}  // namespace collision_monitor::test
