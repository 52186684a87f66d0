// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <malloc.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "product_bench.h"
#include "ros_edge/parameters/resource_loader.h"
#include "support/robots/robot_moves.h"
#include "support/scratch_folder.h"
#include "thread_time.h"

namespace collision_monitor::test {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// [s] Of all threads, and of started programs that have ended.
double processorTime() {
  double sum = 0.0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    sum += seconds(usage.ru_utime) + seconds(usage.ru_stime);
  }
  return sum;
}

/// [MB] A line of the system's status of this process: VmRSS, VmHWM.
double memoryOf(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(name + ":", 0) == 0) {
      return std::stod(line.substr(name.size() + 1)) / 1024.0;
    }
  }
  return 0.0;
}

/// Packages as ROS finds them: those that the robot names, and this one.
void findPackages(const RobotFile& robot) {
  const char* path = std::getenv("ROS_PACKAGE_PATH");
  const std::string packages = robot.package_root.string() + ":" + COLLISION_MONITOR_SOURCE_DIR +
                               (path == nullptr ? "" : std::string(":") + path);
  setenv("ROS_PACKAGE_PATH", packages.c_str(), 1);
}

/// Times of starts of one kind.
struct Starts {
  std::vector<double> times;      ///< [s] by the clock
  std::vector<double> processor;  ///< [s]

  CycleSetup build(const RobotFile& robot, const std::filesystem::path& fit_cache) {
    using Clock = std::chrono::steady_clock;
    SetupOptions options;
    options.fit_cache = fit_cache;
    const double before = processorTime();
    const Clock::time_point start = Clock::now();
    CycleSetup setup = buildSetup({describe(robot)}, makeResourceLoader(), options);
    times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    processor.push_back(processorTime() - before);
    return setup;
  }

  void print(const std::string& name) const {
    test::print(name, medianOf(times), "s");
    test::print(name + "_processor", medianOf(processor), "s");
  }
};

/// Prints what a process that checks one robot takes beyond `before`.
void printMemory(const CycleSetup& setup, double before) {
  constexpr std::size_t kCycles = 100;
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::automatic);
  {
    std::vector<LinkPoses> move = Mover(setup.model, 1000.0, 1.0).next();
    move.resize(kCycles);
    for (const LinkPoses& poses : move) {
      runCycle(setup, poses, buffers);
    }
  }
  malloc_trim(0);  // as the monitor does; and the moves do not count
  print("memory_grown", memoryOf("VmRSS") - before, "MB");
  print("memory_most", memoryOf("VmHWM") - before, "MB");
}

}  // namespace

CycleSetup measureStart(const RobotFile& robot) {
  constexpr std::size_t kStarts = 3;
  constexpr double kLong = 2.0;  // [s] longer starts are measured once
  findPackages(robot);
  Starts first;
  Starts later;
  std::optional<ScratchFolder> fit_cache;
  while (first.times.empty() || (first.times.size() < kStarts && first.times.back() < kLong)) {
    fit_cache.emplace();
    const double resident = memoryOf("VmRSS");
    const CycleSetup new_setup = first.build(robot, fit_cache->path());
    if (first.times.size() == 1) {
      printMemory(new_setup, resident);
    }
  }
  CycleSetup setup = later.build(robot, fit_cache->path());
  while (later.times.size() < kStarts) {
    setup = later.build(robot, fit_cache->path());
  }
  first.print("start_without_cache");
  later.print("start_from_cache");
  return setup;
}

}  // namespace collision_monitor::test
