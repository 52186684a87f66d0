// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <optional>

#include "motion_bench.h"
#include "support/robots/random_motions.h"

namespace collision_monitor::test {
namespace {

constexpr double kCycle = 0.02;   ///< [s] 0.1 m in this time is 5 m/s
constexpr int kSteps = 10000;     ///< of a subdivision
constexpr double kTime = 1e-6;    ///< [s] allowed difference of a contact from the subdivision
constexpr double kLength = 1e-6;  ///< [m]

/// The reported contacts of many plates, beside a subdivision of the cycle.
struct Tally {
  int count{0};
  int told{0};           ///< contacts reported
  int shown{0};          ///< contacts at a step of the subdivision
  int missed{0};         ///< shown, but not told, or told more than kTime later
  int unfounded{0};      ///< told, but farther apart than kLength at that time
  double farthest{0.0};  ///< [m] greatest distance at the time told
  double before{0.0};    ///< [s] from the contact told to the first step that shows it
  std::uint64_t steps{0};
};

void count(const PlateCrossing& scene, Tally& tally) {
  const SweptContact found = meetConvex(scene.plate, scene.still, scene.body, scene.crossing);
  const std::optional<int> shown = firstOverlap(scene, kSteps);
  const bool is_told = found.state == SweepState::contact;
  ++tally.count;
  tally.told += is_told ? 1 : 0;
  tally.shown += shown ? 1 : 0;
  tally.steps += found.work;
  if (is_told) {
    const double distance = distanceAt(scene, found.time);
    tally.farthest = std::max(tally.farthest, distance);
    tally.unfounded += distance > kLength ? 1 : 0;
  }
  if (shown) {
    const double before = kCycle * (static_cast<double>(*shown) / kSteps - found.time);
    tally.before = std::max(tally.before, before);
    tally.missed += !is_told || before < -kTime ? 1 : 0;
  }
}

void print(const std::string& name, const Tally& tally) {
  const auto print_of = [&](const char* what, double value) {
    test::print((name + "_" + what).c_str(), value);
  };
  print_of("count", tally.count);
  print_of("told", tally.told);
  print_of("shown", tally.shown);
  print_of("missed", tally.missed);
  print_of("unfounded", tally.unfounded);
  print_of("farthest_m", tally.farthest);
  print_of("before_s", tally.before);
  print_of("looks", static_cast<double>(tally.steps) / tally.count);
}

}  // namespace

void runCrossings(int crossings, int passes, int looked_through) {
  Random random(20260101);
  Tally crossing;
  Tally passing;
  int agreeing = 0;
  for (int i = 0; i < crossings; ++i) {
    count(randomCrossing(random), crossing);
  }
  for (int i = 0; i < passes; ++i) {
    count(randomCrossing(random, 0.06), passing);
  }
  for (int i = 0; i < looked_through; ++i) {
    agreeing += isAsEveryStepShows(randomCrossing(random, i % 2 == 0 ? 0.3 : 0.06), kSteps) ? 1 : 0;
  }
  print("crossing", crossing);
  print("passing", passing);
  print("looked_through", looked_through);
  print("agreeing", agreeing);
}

}  // namespace collision_monitor::test
