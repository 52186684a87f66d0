// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <numeric>

#include "fcl_path.h"
#include "motion_bench.h"
#include "pipeline/trajectory/check_trajectory.h"
#include "support/robots/robot_moves.h"

namespace collision_monitor::test {
namespace {

/// The first movable joints, up to seven, each on its own sine about the middle of its range: 100
/// way-points a tenth of a second apart.
JointPath makePath(const RobotModel& model) {
  constexpr std::size_t kWaypoints = 100;
  JointPath path;
  for (std::size_t i = 0; i < model.joints.size() && path.joints.size() < 7; ++i) {
    const Joint& joint = model.joints[i];
    if (!joint.mimic &&
        (joint.type == JointType::revolute || joint.type == JointType::continuous)) {
      path.joints.push_back(idAt<JointId>(i));
    }
  }
  for (std::size_t k = 0; k < kWaypoints; ++k) {
    path.times.push_back(0.1 * static_cast<double>(k));
    for (std::size_t i = 0; i < path.joints.size(); ++i) {
      const Joint& joint = model.joint(path.joints[i]);
      const double lower = std::max(joint.lower, -3.0);
      const double upper = std::min(joint.upper, 3.0);
      const double phase = 0.06 * static_cast<double>(k) + 0.9 * static_cast<double>(i);
      path.positions.push_back(0.5 * (lower + upper) + 0.3 * (upper - lower) * std::sin(phase));
    }
  }
  return path;
}

void printReport(const JointPath& path, const TrajectoryReport& report) {
  const auto count_of = [&](ApproachState state) {
    return static_cast<double>(
        std::count_if(report.pairs.begin(), report.pairs.end(),
                      [&](const PairApproach& pair) { return pair.state == state; }));
  };
  print("joints", static_cast<double>(path.joints.size()));
  print("waypoints", static_cast<double>(path.times.size()));
  print("pairs", static_cast<double>(report.pairs.size()));
  print("contacts", count_of(ApproachState::contact));
  print("undecided", count_of(ApproachState::undecided) + count_of(ApproachState::unknown));
  print("steps", static_cast<double>(report.work));
}

/// Times all samples, or a part of them if there are many.
void timeSamples(FclPath& fcl, const std::string& name, double resolution, std::size_t part,
                 const std::vector<double>& contact_times) {
  const std::vector<std::uint64_t> samples = countSamples(fcl, 2.0 * resolution);
  const std::clock_t start = std::clock();
  const std::uint64_t taken = sampleOverlaps(fcl, samples, part, contact_times);
  const double time = millisecondsSince(start);
  const auto all = std::accumulate(samples.begin(), samples.end(), std::uint64_t{0});
  print((name + "_samples").c_str(), static_cast<double>(all));
  print((name + "_taken").c_str(), static_cast<double>(taken));
  print((name + "_taken_ms").c_str(), time);
}

/// FCL has to check each pair up to the contact that we found.
std::vector<double> contactTimes(const TrajectoryReport& report) {
  std::vector<double> times;
  for (const PairApproach& pair : report.pairs) {
    times.push_back(pair.state == ApproachState::contact ? pair.time
                                                         : std::numeric_limits<double>::infinity());
  }
  return times;
}

}  // namespace

int runTrajectory(const std::string& name, std::size_t part) {
  const std::optional<RobotFile> robot = findRobot(name);
  if (!robot) {
    return 1;
  }
  const CycleSetup setup =
      buildSetup({describe(*robot)}, fileLoader(robot->package_root), SetupOptions());
  const JointPath path = makePath(setup.model);
  const LinkPoses start = posesAt(setup.model, defaultPositions(setup.model));
  const TrajectoryOptions options;
  TrajectoryOptions contacts_only;
  contacts_only.margin = 0.0;
  TrajectoryReport report;
  print("ours_ms",
        medianMilliseconds(9, [&] { report = checkTrajectory(setup, path, start, options); }));
  print("ours_contacts_ms",
        medianMilliseconds(9, [&] { checkTrajectory(setup, path, start, contacts_only); }));
  print("tolerance_m", options.tolerance);
  printReport(path, report);
  FclPath fcl(setup, path, start);
  const std::vector<double> contact_times = contactTimes(report);
  timeSamples(fcl, "fcl_coarse", 1e-3, 1, contact_times);
  timeSamples(fcl, "fcl", options.tolerance, part, contact_times);
  std::size_t contacts = 0;
  const std::clock_t begin = std::clock();
  print("fcl_distances", static_cast<double>(followDistances(fcl, options.tolerance, contacts)));
  print("fcl_distances_ms", millisecondsSince(begin));
  print("fcl_contacts", static_cast<double>(contacts));
  return 0;
}

}  // namespace collision_monitor::test
