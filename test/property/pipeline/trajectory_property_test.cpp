// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "pipeline/data/motion_bound.h"
#include "pipeline/trajectory/check_trajectory.h"
#include "pipeline/trajectory/link_pair_distance.h"
#include "pipeline/trajectory/path_poses.h"
#include "support/fixed_seed.h"
#include "support/robots/file_loader.h"

namespace collision_monitor::test {
namespace {

/// A shipped robot, read and fitted once.
const CycleSetup& setupOf(const std::string& name) {
  static std::map<std::string, CycleSetup> setups;
  auto found = setups.find(name);
  if (found == setups.end()) {
    for (const RobotFile& robot : allRobotFiles()) {
      if (robot.name == name) {
        found = setups
                    .emplace(name, buildSetup({describe(robot)}, fileLoader(robot.package_root),
                                              SetupOptions()))
                    .first;
      }
    }
  }
  return found->second;
}

double within(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

/// Every joint of its own that turns or slides, over two parts of the way or more.
JointPath anyPath(const RobotModel& model, std::vector<double> times = {0.0, 1.0, 1.5}) {
  JointPath path;
  path.times = std::move(times);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const JointType type = model.joints[i].type;
    if (!model.joints[i].mimic && (type == JointType::revolute || type == JointType::continuous ||
                                   type == JointType::prismatic)) {
      path.joints.push_back(idAt<JointId>(i));
    }
  }
  const bool is_cubic = *rc::gen::arbitrary<bool>();
  for (std::size_t k = 0; k < path.times.size(); ++k) {
    for (const JointId joint : path.joints) {
      const double lower = std::max(-2.0, model.joint(joint).lower);
      const double upper = std::min(2.0, model.joint(joint).upper);
      path.positions.push_back(within(lower, upper));
      if (is_cubic) {
        path.velocities.push_back(within(-1.0, 1.0));
      }
    }
  }
  return path;
}

LinkPoses poseAtZero(const RobotModel& model) {
  LinkPoses poses = makeLinkPoses(model);
  placeLinks(model, defaultPositions(model), std::vector<Pose>(model.robots.size()),
             poses.world_from_link);
  std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
  return poses;
}

const char* const kRobots[] = {"urdf/arm6.urdf", "urdf/dual_arm.urdf"};

/// The ways of all joints in a part, and how far the distance of two links may change at most.
RC_GTEST_PROP(TrajectoryLaws, distancesChangeByNoMoreThanTheBound, ()) {
  const CycleSetup& setup = setupOf(
      *rc::gen::elementOf(std::vector<std::string>(std::begin(kRobots), std::end(kRobots))));
  const JointPath path = anyPath(setup.model);
  const LinkPoses start = poseAtZero(setup.model);
  PathPoses poses(setup.model, path, start);
  LinkPairMeasures measures(setup);
  const double from = within(0.0, 1.0);
  const double to = from + (1.0 - from) * within(0.0, 1.0);
  std::vector<Pose> at_start;
  std::vector<Pose> at_end;
  poses.place(0, from, at_start);
  poses.place(0, to, at_end);
  std::vector<double> travels;
  for (std::size_t i = 0; i < path.joints.size(); ++i) {
    travels.push_back(travelOf(path, {0, from, to}, i));
  }
  JointLevers levers(measures.balls, setup.model, path);
  levers.moveTo(at_start);
  for (LinkPairIndex pair = 0; pair < setup.checked.size(); ++pair) {
    const CheckedLinkPair& links = setup.checked[pair];
    const LinkChain chain = chainBetween(setup.model, path, links.a, links.b);
    const double bound = boundMotion(chain, travels, levers);
    const double change = bodyDistance(measures, pair, at_end).measured.distance -
                          bodyDistance(measures, pair, at_start).measured.distance;
    RC_ASSERT(std::abs(change) <= bound + 1e-9);
  }
}

/// Points on the sphere about a link, in the frame of another.
std::vector<Eigen::Vector3d> seenFrom(LinkId from, LinkId link, const Ball& ball,
                                      const std::vector<Pose>& world_from_link) {
  std::vector<Eigen::Vector3d> points;
  const Pose seen = inverse(world_from_link[index(from)]) * world_from_link[index(link)];
  for (int axis = 0; axis < 3; ++axis) {
    points.push_back(seen * (ball.center + ball.radius * Eigen::Vector3d::Unit(axis)));
    points.push_back(seen * (ball.center - ball.radius * Eigen::Vector3d::Unit(axis)));
  }
  return points;
}

/// Seen from one link, points of another move in a line, up to the deviation.
RC_GTEST_PROP(TrajectoryLaws, pointsDeviateByNoMoreThanTheBound, ()) {
  const CycleSetup& setup = setupOf(
      *rc::gen::elementOf(std::vector<std::string>(std::begin(kRobots), std::end(kRobots))));
  const JointPath path = anyPath(setup.model);
  const LinkPoses start = poseAtZero(setup.model);
  PathPoses poses(setup.model, path, start);
  const std::vector<Ball> balls = linkBalls(setup);
  const double from = within(0.0, 1.0);
  const double to = from + (1.0 - from) * within(0.0, 1.0);
  std::vector<JointStep> steps;
  for (std::size_t i = 0; i < path.joints.size(); ++i) {
    steps.push_back(stepOf(path, {0, from, to}, i));
  }
  const double time = within(-1.0, 1.0);
  std::vector<Pose> middle;
  std::vector<Pose> then;
  poses.place(0, 0.5 * (from + to), middle);
  poses.place(0, 0.5 * (from + to) + 0.5 * time * (to - from), then);
  for (const CheckedLinkPair& links : setup.checked) {
    const LinkChain chain = chainBetween(setup.model, path, links.a, links.b);
    for (const LinkChain& seen : {chain, reversed(chain)}) {
      const RelativeMotion motion = relativeMotion(seen, balls, middle, steps);
      const Ball& ball = balls[index(seen.b)];
      const auto before = seenFrom(seen.a, seen.b, ball, middle);
      const auto after = seenFrom(seen.a, seen.b, ball, then);
      const Pose& world_from_a = middle[index(seen.a)];
      for (std::size_t i = 0; i < before.size(); ++i) {
        const Eigen::Vector3d moved = world_from_a.rotation * (after[i] - before[i]);
        const Eigen::Vector3d line = time * motion.velocityAt(world_from_a * before[i]);
        RC_ASSERT((moved - line).norm() <= motion.deviation + 1e-9);
      }
    }
  }
}

RC_GTEST_PROP(TrajectoryLaws, samplesShowNothingThatWasNotTold, ()) {
  const CycleSetup& setup = setupOf(
      *rc::gen::elementOf(std::vector<std::string>(std::begin(kRobots), std::end(kRobots))));
  const JointPath path = anyPath(setup.model);
  const LinkPoses start = poseAtZero(setup.model);
  const TrajectoryReport report = checkTrajectory(setup, path, start, TrajectoryOptions());
  PathPoses poses(setup.model, path, start);
  LinkPairMeasures measures(setup);
  std::vector<Pose> world_from_link;
  constexpr int kSamples = 40;
  for (int i = 0; i <= kSamples; ++i) {
    const std::size_t segment = i < kSamples / 2 ? 0 : 1;
    const double share = 2.0 * i / kSamples - static_cast<double>(segment);
    poses.place(segment, share, world_from_link);
    for (LinkPairIndex pair = 0; pair < report.pairs.size(); ++pair) {
      const PairApproach& approach = report.pairs[pair];
      RC_ASSERT(approach.state == ApproachState::clear || approach.state == ApproachState::contact);
      if (approach.state == ApproachState::clear ||
          timeAt(path, segment, share) < approach.time - 1e-4) {
        const PairDistance found = elementDistance(measures, pair, world_from_link);
        RC_ASSERT(found.quality != Quality::estimate);
        RC_ASSERT(found.measured.distance >= approach.at_least - 1e-9);
        RC_ASSERT(found.measured.distance > 0.0);
      }
    }
  }
}

/// Way-points [first, last] of a path, as a path of its own.
JointPath partOf(const JointPath& path, std::size_t first, std::size_t last) {
  const auto cut = [&](const std::vector<double>& values, std::size_t size) {
    return values.empty()
               ? values
               : std::vector<double>(values.begin() + static_cast<long>(first * size),
                                     values.begin() + static_cast<long>((last + 1) * size));
  };
  const std::size_t joints = path.joints.size();
  return {path.joints, cut(path.times, 1), cut(path.positions, joints),
          cut(path.velocities, joints)};
}

/// Paths of few way-points are searched without blocks of states.
RC_GTEST_PROP(TrajectoryLaws, manyWaypointsAtOnce_tellWhatTheirPartsTell, ()) {
  const CycleSetup& setup = setupOf(
      *rc::gen::elementOf(std::vector<std::string>(std::begin(kRobots), std::end(kRobots))));
  const JointPath path =
      anyPath(setup.model, {0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0});
  const LinkPoses start = poseAtZero(setup.model);
  const TrajectoryOptions options;
  const TrajectoryReport whole = checkTrajectory(setup, path, start, options);
  const TrajectoryReport parts[] = {checkTrajectory(setup, partOf(path, 0, 5), start, options),
                                    checkTrajectory(setup, partOf(path, 5, 10), start, options)};
  for (LinkPairIndex pair = 0; pair < setup.checked.size(); ++pair) {
    const PairApproach& found = whole.pairs[pair];
    const bool is_early = parts[0].pairs[pair].state == ApproachState::contact;
    const PairApproach& expected = parts[is_early ? 0 : 1].pairs[pair];
    RC_ASSERT(found.state == expected.state);
    if (found.state == ApproachState::contact) {
      RC_ASSERT(std::abs(found.time - expected.time) < 1e-4);
    } else {
      const double nearest = std::min(expected.nearest.measured.distance,
                                      parts[0].pairs[pair].nearest.measured.distance);
      RC_ASSERT(found.at_least <= nearest + 1e-9);
      RC_ASSERT(nearest > options.margin ||
                std::abs(found.nearest.measured.distance - nearest) <= options.resolution + 1e-9);
    }
  }
}

RC_GTEST_PROP(TrajectoryLaws, contactsAndNearMisses_areThereAtTheTimeTold, ()) {
  const CycleSetup& setup = setupOf(kRobots[0]);
  const JointPath path = anyPath(setup.model);
  const LinkPoses start = poseAtZero(setup.model);
  const TrajectoryOptions options;
  const TrajectoryReport report = checkTrajectory(setup, path, start, options);
  PathPoses poses(setup.model, path, start);
  LinkPairMeasures measures(setup);
  std::vector<Pose> world_from_link;
  for (LinkPairIndex pair = 0; pair < report.pairs.size(); ++pair) {
    const PairApproach& approach = report.pairs[pair];
    const std::size_t segment = approach.time < path.times[1] ? 0 : 1;
    const double share =
        (approach.time - path.times[segment]) / (path.times[segment + 1] - path.times[segment]);
    poses.place(segment, share, world_from_link);
    const double distance = elementDistance(measures, pair, world_from_link).measured.distance;
    if (approach.state == ApproachState::contact) {
      RC_ASSERT(distance <= options.tolerance + 1e-9);
    } else if (approach.nearest.measured.distance <= options.margin) {
      RC_ASSERT(std::abs(distance - approach.nearest.measured.distance) <= 1e-9);
      RC_ASSERT(approach.nearest.measured.distance - approach.at_least <=
                options.resolution + 1e-9);
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
