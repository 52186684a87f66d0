// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "collision_monitor/narrow_phase/distance.h"
#include "support/random_pairs.h"
#include "support_fcl/fcl_adapter.h"

// Time of one signed distance (with both points and the normal) for each kind of pair, and
// FCL's distance (unsigned, no points) and overlap test on the same pairs in the same run. Sizes
// are those of robot links; pairs are made before the clock starts.
namespace collision_monitor::test {
namespace {

constexpr std::size_t kPairCount = 4096;

enum class Mix { mixed, separated, overlapping };

struct Scene {
  ShapeKind a;
  ShapeKind b;
  Mix mix;
};

// Thirds of separated, near and overlapping pairs, or one sort only.
std::vector<ShapePair> makePairs(const Scene& scene) {
  constexpr Nearness kMixed[] = {Nearness::separated, Nearness::near, Nearness::overlapping};
  Random random(20260101);
  std::vector<ShapePair> pairs;
  for (std::size_t i = 0; i < kPairCount; ++i) {
    Nearness nearness = kMixed[i % 3];
    if (scene.mix != Mix::mixed) {
      nearness = scene.mix == Mix::separated ? Nearness::separated : Nearness::overlapping;
    }
    pairs.push_back(randomPair({scene.a, scene.b, nearness, Alignment::random, 0.02, 0.5}, random));
  }
  return pairs;
}

void measureOurs(benchmark::State& state, const Scene& scene) {
  const std::vector<ShapePair> pairs = makePairs(scene);
  std::size_t next = 0;
  for ([[maybe_unused]] const auto unused : state) {
    const ShapePair& pair = pairs[next++ % kPairCount];
    benchmark::DoNotOptimize(distanceBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b));
  }
}

template <class Query>
void measureFcl(benchmark::State& state, const Scene& scene, const Query& query) {
  std::vector<FclObject> objects_a;
  std::vector<FclObject> objects_b;
  for (const ShapePair& pair : makePairs(scene)) {
    objects_a.push_back(*toFcl(pair.a, pair.world_from_a));
    objects_b.push_back(*toFcl(pair.b, pair.world_from_b));
  }
  std::size_t next = 0;
  for ([[maybe_unused]] const auto unused : state) {
    const std::size_t i = next++ % kPairCount;
    benchmark::DoNotOptimize(query(objects_a[i], objects_b[i]));
  }
}

void registerScene(const Scene& scene) {
  constexpr const char* kMixNames[] = {"mixed", "separated", "overlapping"};
  const std::string name = std::string(nameOf(scene.a)) + "-" + nameOf(scene.b) + "/" +
                           kMixNames[static_cast<std::size_t>(scene.mix)] + "/";
  benchmark::RegisterBenchmark((name + "signed_distance").c_str(), measureOurs, scene);
  if (scene.a == ShapeKind::rounded_box || scene.b == ShapeKind::rounded_box) {
    return;  // FCL has no rounded box
  }
  benchmark::RegisterBenchmark((name + "fcl_distance").c_str(), [scene](benchmark::State& state) {
    measureFcl(state, scene, fclDistance);
  });
  benchmark::RegisterBenchmark((name + "fcl_overlap").c_str(), [scene](benchmark::State& state) {
    measureFcl(state, scene, fclOverlap);
  });
}

void registerAll() {
  for (const ShapeKind a : kShapeKinds) {
    for (const ShapeKind b : kShapeKinds) {
      for (const Mix mix : {Mix::mixed, Mix::separated, Mix::overlapping}) {
        if (a <= b) {
          registerScene({a, b, mix});
        }
      }
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  collision_monitor::test::registerAll();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
