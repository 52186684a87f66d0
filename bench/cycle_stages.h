// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdio>
#include <map>
#include <string>

#include "pipeline/cycle/cull_candidates.h"
#include "pipeline/cycle/distance_cache.h"
#include "pipeline/cycle/judge_pairs.h"
#include "pipeline/cycle/keep_near.h"
#include "pipeline/cycle/list_near.h"
#include "pipeline/cycle/measure_pairs.h"
#include "pipeline/cycle/measure_told.h"
#include "pipeline/cycle/place_bodies.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/cycle/scale_speed.h"
#include "pipeline/cycle/settled_pairs.h"
#include "pipeline/data/activation_distance.h"
#include "pipeline/look_ahead/bound_bodies.h"
#include "pipeline/look_ahead/find_closings.h"
#include "pipeline/look_ahead/find_motions.h"
#include "pipeline/look_ahead/link_walk.h"
#include "pipeline/objects/find_resting.h"

namespace collision_monitor::test {

using Clock = std::chrono::steady_clock;

inline double microsecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

/// Mean times of the stages of runCycle [us].
class Stages {
 public:
  /// As runCycle, without its counters.
  void run(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) {
    last_ = Clock::now();
    find(setup, poses, buffers);
    measureExpected(setup, poses, buffers);
    judge(setup, poses, buffers);
  }

  void print(double cycles) const {
    for (const auto& [name, time] : times_) {
      std::printf("    %-40s %8.2f us\n", name.c_str(), time / cycles);
    }
    std::printf("    %.2f %% of the cycles measured twice, %.2f %% looked at all pairs\n",
                100.0 * repeated_ / cycles, 100.0 * unexpected_ / cycles);
  }

 private:
  void find(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) {
    findResting(setup, poses, buffers.memory.last, buffers.body_poses);
    placeBodies(setup, poses, buffers.body_poses);
    placeElements(setup, poses, buffers.body_poses);
    const bool have_links_changed = buffers.memory.last.known != buffers.body_poses.link_known;
    buffers.memory.judges_all = buffers.memory.judges_all || have_links_changed;
    findMotions(setup, poses, buffers.body_poses, buffers.memory, buffers.sweep);
    end("1 findResting, placeBodies, findMotions");
    lookAhead(setup, poses, buffers.body_poses, setup.ahead.horizon, buffers.bounds);
    accumulateTravel(setup, poses, buffers);
    listNear(setup, poses, have_links_changed, buffers);
    end("3 lookAhead, accumulateTravel, listNear");
    buffers.refine.elapsed = buffers.sweep.elapsed;
  }

  void measureExpected(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) {
    if (buffers.refine.tells_all) {
      expectNothing(buffers.robots);
    }
    measure(setup, poses, buffers);
    if (isMoreThanExpected(setup, buffers.robots, buffers.events)) {
      expectFound(setup, buffers.robots);
      buffers.refine.work_before = buffers.refine.work_done;
      measure(setup, poses, buffers);
      buffers.refine.work_before = 0;
      repeated_ += 1.0;
    }
    keepProven(setup, buffers);
    end("9 measureClosest, findClosings, measureTold, keepProven");
    if (setup.is_continuous) {
      sweepPairs(setup, buffers.memory.refined, buffers.refine, buffers.sweep, buffers.distances);
      end("a sweepPairs");
    }
  }

  void measure(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) {
    findActivationDistances(setup, poses, buffers.robots, buffers.sweep, buffers.activation);
    end("4 findActivationDistances");
    cullCandidates(setup, poses, buffers);
    end("5 cullCandidates");
    measurePairs(setup, buffers.body_poses, buffers.candidates, buffers.distances);
    keepNear(setup, poses, buffers);
    end("7 measurePairs, keepNear");
    refinePairs(setup, buffers.body_poses, buffers.memory, buffers.refine, buffers.distances);
    measureDeferred(setup, poses, buffers);
    end("8 refinePairs, measureDeferred");
    if (buffers.passed_over == 0) {
      measureClosest(setup, poses, leastActivationDistanceOf(setup), buffers);
    }
    findClosings(setup, poses, buffers.distances);
    measureTold(setup, poses, buffers);
    end("9 measureClosest, findClosings, measureTold, keepProven");
  }

  void judge(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) {
    keepPoses(poses, buffers.body_poses, buffers.memory.last);
    judgePairs(setup, buffers.body_poses, poses.velocities, buffers.distances, buffers.memory,
               buffers.events);
    scaleSpeed(setup, poses.stamp_ns, buffers.distances, buffers.events, buffers.memory.reported,
               buffers.memory.speed, buffers.robots);
    if (!buffers.refine.tells_all) {
      expectNext(setup, buffers.robots);
      unexpected_ += expectsNothing(buffers.robots.expected.front()) ? 1.0 : 0.0;
    }
    keepLively(setup, buffers.events, buffers.memory);
    end("b keepPoses, judgePairs, scaleSpeed");
  }

  void end(const std::string& stage) {
    times_[stage] += microsecondsSince(last_);
    last_ = Clock::now();
  }

  Clock::time_point last_;
  std::map<std::string, double> times_;
  double repeated_{0.0};
  double unexpected_{0.0};
};

}  // namespace collision_monitor::test
