// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/measure_pairs.h"

#include <algorithm>
#include <limits>

#include "collision_monitor/narrow_phase/pair_rows.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/distance.h"

namespace collision_monitor {
namespace {

Quality qualityOf(const CycleSetup& setup, const BodyPair& pair) noexcept {
  const bool is_exact =
      setup.bodies[index(pair.a)].is_exact && setup.bodies[index(pair.b)].is_exact;
  return is_exact ? Quality::exact : Quality::lower_bound;
}

PairDistance measurePair(const CycleSetup& setup, const BodyPoses& body_poses, PairId id) noexcept {
  const BodyPair& pair = setup.table[id];
  const std::size_t a = index(pair.a);
  const std::size_t b = index(pair.b);
  return {id, qualityOf(setup, pair), false,
          distanceBetween(setup.bodies[a].shape, body_poses.world_from_body[a],
                          setup.bodies[b].shape, body_poses.world_from_body[b])};
}

/// Rows hold the simpler core first; the table holds the body of the lower id first.
bool isSwapped(const CycleSetup& setup, const BodyPair& pair) noexcept {
  return setup.cores[index(pair.a)].kind > setup.cores[index(pair.b)].kind;
}

void writePair(const CycleSetup& setup, const BodyPoses& body_poses, PairId id, std::size_t row,
               PairRows& rows) noexcept {
  const BodyPair& pair = setup.table[id];
  const bool is_swapped = isSwapped(setup, pair);
  const std::size_t a = index(pair.a);
  const std::size_t b = index(pair.b);
  writeRow(setup.cores[a], body_poses.world_from_body[a], row, is_swapped ? rows.b : rows.a);
  writeRow(setup.cores[b], body_poses.world_from_body[b], row, is_swapped ? rows.a : rows.b);
}

/// Pairs of one kind, at most kRowCount.
struct PairBatch {
  CoreKind a;
  CoreKind b;
  const PairId* first;
  std::size_t count;
};

void measureBatch(const CycleSetup& setup, const BodyPoses& body_poses, const PairBatch& batch,
                  PairDistances& distances) noexcept {
  PairRows rows;  // on the stack; only the numbers that a pair needs are written
  for (std::size_t row = 0; row < batch.count; ++row) {
    writePair(setup, body_poses, batch.first[row], row, rows);
  }
  measureRows(batch.a, batch.b, batch.count, rows);
  // Answers are read straight into their place: copying an entry just after its numbers are written
  // stalls the processor for longer than reading takes.
  PairDistance* measured = &*distances.pairs.insert(distances.pairs.end(), batch.count, {});
  for (std::size_t row = 0; row < batch.count; ++row, ++measured) {
    const BodyPair& pair = setup.table[batch.first[row]];
    measured->pair = batch.first[row];
    measured->quality = qualityOf(setup, pair);
    readAnswer(rows, row, isSwapped(setup, pair), measured->measured);
  }
}

/// By ElementPairIndex: refined, or of two parts; a search skips these.
const std::vector<unsigned char>& passedElements(const CycleSetup& setup,
                                                 const BodyPoses& body_poses,
                                                 RefineWork& refined) noexcept {
  if (!body_poses.is_split) {
    return refined.is_measured;
  }
  for (std::size_t i = 0; i < setup.element_pairs.size(); ++i) {
    const CheckedLinkPair& links = setup.checked[setup.element_pairs[i].link_pair];
    const bool is_passed = refined.is_measured[i] != 0 || !isJoined(body_poses, links.a, links.b);
    refined.is_passed[i] = is_passed ? 1 : 0;
  }
  return refined.is_passed;
}

}  // namespace

void measurePairs(const CycleSetup& setup, const BodyPoses& body_poses,
                  const std::vector<PairId>& pairs, PairDistances& distances) noexcept {
  distances.pairs.clear();
  addPairs(setup, body_poses, pairs, distances);
}

void addPairs(const CycleSetup& setup, const BodyPoses& body_poses,
              const std::vector<PairId>& pairs, PairDistances& distances) noexcept {
  std::size_t next = 0;
  for (const PairRange& range : setup.ranges) {
    while (next < pairs.size() && index(pairs[next]) < range.last) {
      const std::size_t end = std::min(pairs.size(), next + kRowCount);
      std::size_t stop = next + 1;
      while (stop < end && index(pairs[stop]) < range.last) {
        ++stop;
      }
      measureBatch(setup, body_poses, {range.a, range.b, &pairs[next], stop - next}, distances);
      next = stop;
    }
  }
}

void measureClosest(const CycleSetup& setup, const LinkPoses& poses, double reach,
                    CycleBuffers& buffers) noexcept {
  auto& measured = buffers.distances.pairs;
  const auto nearest = std::min_element(measured.begin(), measured.end(), comesNearer);
  if (nearest != measured.end() && nearest->measured.distance <= reach) {
    return;
  }
  NearestPair found;
  if (nearest != measured.end()) {
    found = {nearest->pair, nearest->measured.distance};
  }
  const BodyPoses& body_poses = buffers.body_poses;
  const ObjectTrees& trees = buffers.trees;
  const std::vector<unsigned char>& is_passed = passedElements(setup, body_poses, buffers.refine);
  searchBlocks(trees.trees.empty() ? setup.blocks : trees.blocks, body_poses.rows,
               {setup.element_pair_of, is_passed}, found);
  searchTrees(setup, poses, body_poses, trees, is_passed, found);
  if (!(found.distance < std::numeric_limits<double>::infinity())) {
    return;
  }
  const auto place = std::lower_bound(
      measured.begin(), measured.end(), found.pair,
      [](const PairDistance& distance, PairId pair) { return distance.pair < pair; });
  if (place == measured.end() || place->pair != found.pair) {
    measured.insert(place, measurePair(setup, body_poses, found.pair));
  }
}

}  // namespace collision_monitor
