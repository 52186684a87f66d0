// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What happens between poses: plates that cross at speed, and a trajectory checked for all of its
// way beside samples of it checked with FCL. One line a number, as figures/motion.py reads them.
//   motion_bench crossings COUNT SUBDIVIDED
//   motion_bench trajectory [ROBOT]      a name within that of a robot of the shared data or urdf/
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/pipeline/check_trajectory.h"
#include "collision_monitor/pipeline/motion_bound.h"
#include "fitting/surrounding_mesh.h"
#include "pipeline/link_pair_distance.h"
#include "pipeline/path_poses.h"
#include "support/convex_measure.h"
#include "support/file_loader.h"
#include "support/random_motions.h"
#include "support_fcl/fcl_mesh.h"

namespace collision_monitor::test {
namespace {

/// Of the processor, so that what else runs on the machine does not count.
double millisecondsSince(std::clock_t start) {
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

template <class Run>
double medianTime(int runs, const Run& run) {
  std::vector<double> times;
  for (int i = 0; i < runs; ++i) {
    const std::clock_t start = std::clock();
    run();
    times.push_back(millisecondsSince(start));
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void print(const char* name, double value) { std::printf("%s %.9g\n", name, value); }

double distanceAt(const PlateCrossing& scene, double time) {
  return measureCold(scene.plate, poseAt(scene.still, time), scene.body,
                     poseAt(scene.crossing, time))
      .measured.distance;
}

/// 5 m/s at 50 Hz; a subdivision into 10,000 steps shows each contact or does not.
void runCrossings(int count, int subdivided) {
  constexpr double kCycle = 0.02;  // [s]
  constexpr int kSteps = 10000;
  Random random(20260101);
  int caught = 0;
  std::uint64_t steps = 0;
  double farthest = 0.0;
  double earliest = 0.0;
  for (int i = 0; i < count; ++i) {
    const PlateCrossing scene = randomCrossing(random);
    const SweptContact found = meetConvex(scene.plate, scene.still, scene.body, scene.crossing);
    caught += found.state == SweepState::contact ? 1 : 0;
    steps += found.steps;
    farthest = std::max(farthest, distanceAt(scene, found.time));
    for (int step = 0; i < subdivided && step < found.time * kSteps; ++step) {
      const double time = static_cast<double>(step) / kSteps;
      if (distanceAt(scene, time) <= 0.0) {
        earliest = std::max(earliest, (found.time - time) * kCycle);
        break;
      }
    }
  }
  print("crossings", count);
  print("caught", caught);
  print("distances_each", static_cast<double>(steps) / count);
  print("farthest_m", farthest);
  print("subdivided", std::min(count, subdivided));
  print("late_s", earliest);
}

const RobotFile* findRobot(const std::vector<RobotFile>& robots, const std::string& name) {
  for (const RobotFile& robot : robots) {
    if (robot.name.find(name) != std::string::npos) {
      return &robot;
    }
  }
  return nullptr;
}

/// The first joints that move, up to seven, each on a sine of its own about the middle of its
/// range: 100 way-points a tenth of a second apart.
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

TriangleMesh meshOf(const Geometry& geometry) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&geometry)) {
    return *mesh;
  }
  if (const auto* box = std::get_if<Box>(&geometry)) {
    return surroundingMesh(*box);
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) {
    return surroundingMesh(*cylinder);
  }
  return {};
}

/// The collision meshes of a robot for FCL; other geometries than meshes, boxes and cylinders are
/// left out, which only makes FCL faster.
struct FclRobot {
  explicit FclRobot(const CycleSetup& cycle_setup) : setup(cycle_setup) {
    objects.resize(setup.model.links.size());
    for (std::size_t i = 0; i < setup.model.links.size(); ++i) {
      for (const CollisionElement& element : setup.model.links[i].collisions) {
        TriangleMesh mesh = meshOf(element.geometry);
        for (Eigen::Vector3d& vertex : mesh.vertices) {
          vertex = element.link_from_geometry * vertex;
        }
        if (!mesh.triangles.empty()) {
          objects[i].emplace_back(toFcl(mesh));
        }
      }
    }
  }

  void place(const std::vector<Pose>& world_from_link) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      for (fcl::CollisionObjectd& object : objects[i]) {
        object.setTransform(world_from_link[i].rotation, world_from_link[i].translation);
        object.computeAABB();
      }
    }
  }

  bool overlaps(const CheckedLinkPair& pair) const {
    for (const fcl::CollisionObjectd& a : objects[index(pair.a)]) {
      for (const fcl::CollisionObjectd& b : objects[index(pair.b)]) {
        // As FCL's managers do: bounding boxes first.
        if (a.getAABB().overlap(b.getAABB()) && fclMeshOverlap(a, b)) {
          return true;
        }
      }
    }
    return false;
  }

  const CycleSetup& setup;
  std::vector<std::vector<fcl::CollisionObjectd>> objects;  ///< by LinkId
};

/// Samples for which nothing goes farther than `step` [m] against anything else from one to the
/// next.
std::vector<std::size_t> countSamples(const CycleSetup& setup, const JointPath& path,
                                      PathPoses& poses, double step) {
  const std::vector<Ball> balls = linkBalls(setup);
  std::vector<LinkChain> chains;
  for (const CheckedLinkPair& pair : setup.checked) {
    chains.push_back(chainBetween(setup.model, path, pair.a, pair.b));
  }
  std::vector<std::size_t> counts;
  std::vector<Pose> world_from_link;
  std::vector<double> ways(path.joints.size());
  for (std::size_t segment = 0; segment + 1 < path.times.size(); ++segment) {
    poses.place(segment, 0.0, world_from_link);
    for (std::size_t i = 0; i < ways.size(); ++i) {
      ways[i] = wayOf(path, {segment, 0.0, 1.0}, i);
    }
    double farthest = 0.0;
    for (const LinkChain& chain : chains) {
      farthest = std::max(farthest, boundMotion(chain, balls, world_from_link, ways));
    }
    counts.push_back(
        std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(farthest / step))));
  }
  return counts;
}

/// @return milliseconds; counts the pairs that touch in any sample.
double runFcl(FclRobot& robot, PathPoses& poses, const std::vector<std::size_t>& samples,
              std::size_t& contacts) {
  std::vector<Pose> world_from_link;
  contacts = 0;
  const std::clock_t start = std::clock();
  for (std::size_t segment = 0; segment < samples.size(); ++segment) {
    for (std::size_t i = 0; i < samples[segment]; ++i) {
      poses.place(segment, static_cast<double>(i) / static_cast<double>(samples[segment]),
                  world_from_link);
      robot.place(world_from_link);
      for (const CheckedLinkPair& pair : robot.setup.checked) {
        contacts += robot.overlaps(pair) ? 1 : 0;
      }
    }
  }
  return millisecondsSince(start);
}

int runTrajectory(const std::string& name) {
  const std::vector<RobotFile> robots = allRobotFiles();
  const RobotFile* robot = findRobot(robots, name);
  if (robot == nullptr) {
    std::fprintf(stderr, "no robot '%s' among the shared data and urdf/\n", name.c_str());
    return 1;
  }
  const CycleSetup setup =
      buildSetup({describe(*robot)}, fileLoader(robot->package_root), SetupOptions());
  const JointPath path = makePath(setup.model);
  LinkPoses start = makeLinkPoses(setup.model);
  placeLinks(setup.model, defaultPositions(setup.model), {Pose()}, start.world_from_link);
  std::fill(start.status.begin(), start.status.end(), LinkStatus::known);
  const TrajectoryOptions options;
  TrajectoryOptions contacts_only;
  contacts_only.margin = 0.0;
  TrajectoryReport report;
  const double ours = medianTime(5, [&] { report = checkTrajectory(setup, path, start, options); });
  const double ours_of_contacts =
      medianTime(5, [&] { checkTrajectory(setup, path, start, contacts_only); });
  PathPoses poses(setup.model, path, start);
  // A sample sees what is deeper than half the step to the next.
  const auto samples = countSamples(setup, path, poses, 2.0 * options.resolution);
  FclRobot fcl(setup);
  std::size_t contacts = 0;
  const double theirs = runFcl(fcl, poses, samples, contacts);
  std::size_t sample_count = 0;
  for (const std::size_t count : samples) {
    sample_count += count;
  }
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
  print("steps", static_cast<double>(report.steps));
  print("ours_ms", ours);
  print("ours_contacts_ms", ours_of_contacts);
  print("tolerance_m", options.tolerance);
  print("fcl_resolution_m", options.resolution);
  print("fcl_samples", static_cast<double>(sample_count));
  print("fcl_contacts", static_cast<double>(contacts));
  print("fcl_ms", theirs);
  return 0;
}

int runBench(const std::vector<std::string>& arguments) {
  if (arguments.size() == 3 && arguments[0] == "crossings") {
    runCrossings(std::atoi(arguments[1].c_str()), std::atoi(arguments[2].c_str()));
    return 0;
  }
  if (!arguments.empty() && arguments.size() <= 2 && arguments[0] == "trajectory") {
    return runTrajectory(arguments.size() == 2 ? arguments[1] : "panda_moveit");
  }
  std::fprintf(stderr, "motion_bench crossings COUNT SUBDIVIDED | trajectory [ROBOT]\n");
  return 2;
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  return collision_monitor::test::runBench({argv + 1, argv + argc});
}
