// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "bench_loop.h"
#include "collision_monitor/narrow_phase/pair_rows.h"
#include "narrow_phase/distance.h"
#include "support/instruction_sets.h"
#include "support/random_pairs.h"
#include "support_fcl/fcl_adapter.h"

// Time of one signed distance (with witness points and normal) for each kind of pair: in batches
// with every instruction set of the machine, and by the plain twin. FCL's distance (unsigned, no
// points) and overlap test run on the same pairs in the same run. Sizes are those of robot links.
// Pairs, and rows of pairs, are made before the clock starts. Read items_per_second.
namespace collision_monitor::test {
namespace {

constexpr std::size_t kPairCount = 1024;

enum class Mix { mixed, separated, overlapping };

struct Scene {
  ShapeKind a;
  ShapeKind b;
  Mix mix;
};

// A third each of separated, near and overlapping pairs, or one kind only.
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

void measurePlain(benchmark::State& state, const Scene& scene) {
  askInTurn(state, makePairs(scene), [](const ShapePair& pair) {
    return distanceBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b);
  });
}

void measureBatch(benchmark::State& state, const Scene& scene, std::int64_t instruction_set) {
  const OnlyInstructionSet only(instruction_set);
  const std::vector<ShapePair> pairs = makePairs(scene);
  std::vector<std::unique_ptr<PairRows>> batches;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i % kRowCount == 0) {
      batches.push_back(std::make_unique<PairRows>());
    }
    writeRow(coreOf(pairs[i].a), pairs[i].world_from_a, i % kRowCount, batches.back()->a);
    writeRow(coreOf(pairs[i].b), pairs[i].world_from_b, i % kRowCount, batches.back()->b);
  }
  const CoreKind a = coreKindOf(pairs[0].a);
  const CoreKind b = coreKindOf(pairs[0].b);
  askInTurn(state, batches, [&](const std::unique_ptr<PairRows>& rows) {
    measureRows(a, b, kRowCount, *rows);
    return rows->answers.at[answer::distance][0];
  });
  state.SetItemsProcessed(static_cast<std::int64_t>(kRowCount) * state.iterations());
}

struct FclPair {
  FclObject a;
  FclObject b;
};

template <class Query>
void measureFcl(benchmark::State& state, const Scene& scene, const Query& query) {
  std::vector<FclPair> objects;
  for (const ShapePair& pair : makePairs(scene)) {
    objects.push_back({*toFcl(pair.a, pair.world_from_a), *toFcl(pair.b, pair.world_from_b)});
  }
  askInTurn(state, objects, [&](const FclPair& pair) { return query(pair.a, pair.b); });
}

void registerScene(const Scene& scene) {
  constexpr const char* kMixNames[] = {"mixed", "separated", "overlapping"};
  const std::string name = std::string(nameOf(scene.a)) + "-" + nameOf(scene.b) + "/" +
                           kMixNames[static_cast<std::size_t>(scene.mix)] + "/";
  benchmark::RegisterBenchmark((name + "plain").c_str(), measurePlain, scene);
  for (const std::int64_t instruction_set : instructionSets()) {
    benchmark::RegisterBenchmark((name + "batch_" + hwy::TargetName(instruction_set)).c_str(),
                                 measureBatch, scene, instruction_set);
  }
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
  return collision_monitor::test::runBenchmarks(argc, argv, &collision_monitor::test::registerAll);
}
