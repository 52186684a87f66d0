// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "pipeline/trajectory/check_trajectory.h"
#include "product_bench.h"
#include "support/robots/robot_moves.h"
#include "thread_time.h"

namespace collision_monitor::test {
namespace {

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
  const JointPath path = randomPath(setup.model);
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
