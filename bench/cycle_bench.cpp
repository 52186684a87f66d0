// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Times of whole cycles of moving robots, and of each stage. The joints make 20 moves of half a
// second between random configurations, the fastest at SPEED rad/s. First nobody listens to
// distances, then somebody does, then the motion between cycles is not checked, either.
//   cycle_bench RATE_HZ SPEED [ROBOT...]    robots by a part of their names; panda_moveit and atlas
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>

#include "cycle_stages.h"
#include "narrow_phase/mesh_depth/mesh_depth.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/robot_moves.h"

namespace collision_monitor::test {
namespace {

using Move = std::vector<LinkPoses>;

std::vector<Move> makeMoves(const RobotModel& model, double rate, double speed) {
  Mover mover(model, rate, speed);
  std::vector<Move> moves(20);
  std::generate(moves.begin(), moves.end(), [&] { return mover.next(); });
  return moves;
}

/// Times of cycles with overlapping meshes, whose depth is then measured, and of all others.
struct CycleTimes {
  std::vector<double> deep;
  std::vector<double> free;

  bool add(double time, const PairDistances& distances) {
    const bool is_deep =
        std::any_of(distances.pairs.begin(), distances.pairs.end(),
                    [](const PairDistance& pair) { return pair.quality == Quality::estimate; });
    (is_deep ? deep : free).push_back(time);
    return is_deep;
  }
};

/// Depths of overlapping meshes in some of the cycles, beside those of an unlimited search.
struct Depths {
  double told{0.0};  // [m] sums
  double deepest{0.0};
  std::vector<double> lacking;  // [m]
  std::size_t cycles{0};
  std::unique_ptr<MeshQueryMemory> memory{std::make_unique<MeshQueryMemory>()};

  void add(const CycleSetup& setup, const CycleBuffers& buffers) {
    constexpr std::size_t kEvery = 20;
    if (cycles++ % kEvery != 0) {
      return;
    }
    for (const PairDistance& found : buffers.distances.pairs) {
      const ElementPair& pair = setup.element_pairs[setup.element_pair_of[index(found.pair)]];
      const std::shared_ptr<const MeshTree>& a = setup.elements[index(pair.a)].mesh;
      const std::shared_ptr<const MeshTree>& b = setup.elements[index(pair.b)].mesh;
      if (found.quality == Quality::estimate && a && b) {
        const std::vector<Pose>& poses = buffers.body_poses.world_from_element;
        add(-found.measured.distance, {*a, poses[index(pair.a)]}, {*b, poses[index(pair.b)]});
      }
    }
  }

  void add(double depth, const PlacedMesh& a, const PlacedMesh& b) {
    constexpr std::uint32_t kAll = 1'000'000;
    const auto kept = std::make_unique<KeptDepth>();
    const double whole = -depthOf(a, b, *memory, *kept, kAll).deepest.distance;
    told += depth;
    deepest += whole;
    lacking.push_back(whole - depth);
  }

  void print() {
    if (!lacking.empty()) {
      const auto count = static_cast<double>(lacking.size());
      std::sort(lacking.begin(), lacking.end());
      std::printf(
          "    depths told: mean %.2f mm; searched to the end: %.2f; less by %.2f in one of ten, "
          "%.2f at most\n",
          1e3 * told / count, 1e3 * deepest / count, 1e3 * lacking[lacking.size() * 9 / 10],
          1e3 * lacking.back());
    }
  }
};

void printSpread(const char* what, std::vector<double> times) {
  if (!times.empty()) {
    std::sort(times.begin(), times.end());
    std::printf("    %-40s %zu: median %.1f us, 99 %% %.1f, slowest %.1f\n", what, times.size(),
                times[times.size() / 2], times[times.size() * 99 / 100], times.back());
  }
}

/// Sums over the cycles of a robot.
struct Counts {
  double candidates{0.0};
  double measured{0.0};
  double refined{0.0};
  double swept{0.0};
  double exceeded{0.0};
  double over_cap{0.0};

  void add(const CycleBuffers& buffers) {
    candidates += static_cast<double>(buffers.counters.candidates);
    measured += static_cast<double>(buffers.counters.measured);
    refined += static_cast<double>(buffers.counters.refined);
    swept += static_cast<double>(buffers.counters.swept);
    exceeded += buffers.sweep.step.on_way.is_exceeded ? 1.0 : 0.0;
    over_cap += buffers.sweep.step.at_poses.is_exceeded ? 1.0 : 0.0;
  }
};

void printCycles(const std::string& what, std::vector<double> times, const Counts& counts) {
  const auto cycles = static_cast<double>(times.size());
  std::sort(times.begin(), times.end());
  const double mean = std::accumulate(times.begin(), times.end(), 0.0) / cycles;
  std::printf(
      "  %s: median %.1f us, mean %.1f, 99 %% %.1f; candidates %.0f, measured %.0f, "
      "refined %.1f, followed %.1f a cycle; step too long in %.0f %%, over the cap in %.0f %%\n",
      what.c_str(), times[times.size() / 2], mean, times[times.size() * 99 / 100],
      counts.candidates / cycles, counts.measured / cycles, counts.refined / cycles,
      counts.swept / cycles, 100.0 * counts.exceeded / cycles, 100.0 * counts.over_cap / cycles);
}

void timeCycles(const std::string& what, const CycleSetup& setup, bool tells_all,
                const std::vector<Move>& moves) {
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::automatic);
  CycleBuffers staged = makeBuffers(setup, BroadPhaseKind::automatic);
  buffers.refine.tells_all = staged.refine.tells_all = tells_all;
  Stages stages;
  std::vector<double> times;
  CycleTimes split;
  Depths depths;
  Counts counts;
  for (const Move& move : moves) {
    resetMemory(buffers);
    resetMemory(staged);
    for (const LinkPoses& poses : move) {
      const Clock::time_point start = Clock::now();
      runCycle(setup, poses, buffers);
      times.push_back(microsecondsSince(start));
      if (split.add(times.back(), buffers.distances)) {
        depths.add(setup, buffers);
      }
      stages.run(setup, poses, staged);
      if (staged.events.verdicts != buffers.events.verdicts) {
        std::printf("the stages differ from runCycle: mend the benchmark\n");
        std::exit(1);
      }
      counts.add(buffers);
    }
  }
  printCycles(what, times, counts);
  printSpread("cycles with meshes in each other", split.deep);
  printSpread("cycles without", split.free);
  depths.print();
  stages.print(static_cast<double>(times.size()));
}

void timeRobot(const RobotFile& robot, double rate, double speed) {
  CycleSetup setup = buildSetup({describe(robot)}, fileLoader(robot.package_root), SetupOptions());
  setup.refine.tolerance = kMonitorTolerance;
  const std::vector<Move> moves = makeMoves(setup.model, rate, speed);
  std::printf("%s at %.0f Hz, %g rad/s: %zu shapes, %zu pairs of %zu pairs of links\n",
              robot.name.c_str(), rate, speed, setup.bodies.size(), setup.table.size(),
              setup.checked.size());
  timeCycles("nobody listens to distances", setup, false, moves);
  timeCycles("somebody listens to distances", setup, true, moves);
  setup.is_continuous = false;
  timeCycles("not continuous, either", setup, true, moves);
}

int runBench(double rate, double speed, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const std::optional<RobotFile> robot = findRobot(name);
    if (!robot) {
      return 1;
    }
    timeRobot(*robot, rate, speed);
  }
  return 0;
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  std::vector<std::string> names(argv + std::min(argc, 3), argv + argc);
  const double rate = argc > 2 ? std::atof(argv[1]) : 0.0;
  if (!(rate > 0.0)) {
    std::fprintf(stderr, "cycle_bench RATE_HZ SPEED [ROBOT...]\n");
    return 2;
  }
  if (names.empty()) {
    names = {"panda_moveit", "atlas"};
  }
  return collision_monitor::test::runBench(rate, std::atof(argv[2]), names);
}
