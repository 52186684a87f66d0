// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "collision_monitor/narrow_phase/distance.h"
#include "collision_monitor/narrow_phase/pair_rows.h"
#include "collision_monitor/pipeline/run_cycle.h"
#include "narrow_phase/core_distance.h"

namespace collision_monitor {
namespace {

PairDistance pairDistance(const CycleSetup& setup, PairId id,
                          const SignedDistance& measured) noexcept {
  const BodyPair& pair = setup.table[id];
  const bool is_exact =
      setup.bodies[index(pair.a)].is_exact && setup.bodies[index(pair.b)].is_exact;
  return {id, is_exact ? Quality::exact : Quality::lower_bound, false, measured};
}

PairDistance measurePair(const CycleSetup& setup, const BodyPoses& body_poses, PairId id) noexcept {
  const BodyPair& pair = setup.table[id];
  const std::size_t a = index(pair.a);
  const std::size_t b = index(pair.b);
  return pairDistance(setup, id,
                      distanceBetween(setup.bodies[a].shape, body_poses.world_from_body[a],
                                      setup.bodies[b].shape, body_poses.world_from_body[b]));
}

/// Rows hold the simpler core first, the table the body of the lower id.
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

/// Pairs of one kind, at most kRowCount of them.
struct PairBatch {
  CoreKind a;
  CoreKind b;
  const PairId* first;
  std::size_t count;
};

void measureBatch(const CycleSetup& setup, const BodyPoses& body_poses, const PairBatch& batch,
                  PairDistances& distances) noexcept {
  PairRows rows;  // on the stack, and nothing of it is touched that a pair does not need
  for (std::size_t row = 0; row < batch.count; ++row) {
    writePair(setup, body_poses, batch.first[row], row, rows);
  }
  measureRows(batch.a, batch.b, batch.count, rows);
  for (std::size_t row = 0; row < batch.count; ++row) {
    const PairId id = batch.first[row];
    const SignedDistance measured = readAnswer(rows, row);
    const bool is_swapped = isSwapped(setup, setup.table[id]);
    distances.measured.push_back(
        pairDistance(setup, id, is_swapped ? swapped(measured) : measured));
  }
}

/// Distance of the bounding spheres: a lower bound of the pair's.
double boundDistance(const CycleSetup& setup, const BodyPoses& body_poses,
                     const BodyPair& pair) noexcept {
  const std::size_t a = index(pair.a);
  const std::size_t b = index(pair.b);
  const double centres =
      (body_poses.world_from_body[b].translation - body_poses.world_from_body[a].translation)
          .norm();
  return centres - setup.bodies[a].bounding_radius - setup.bodies[b].bounding_radius;
}

bool isKnown(const BodyPoses& body_poses, const BodyPair& pair) noexcept {
  return body_poses.known[index(pair.a)] != 0 && body_poses.known[index(pair.b)] != 0;
}

/// Among the known pairs, the one whose bounding spheres are nearest: a good first guess
/// makes the search that follows measure few pairs. False if no pair is known.
bool guessClosest(const CycleSetup& setup, const BodyPoses& body_poses, PairId& guess) noexcept {
  double least = std::numeric_limits<double>::infinity();
  bool found = false;
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    const BodyPair& pair = setup.table.pairs()[i];
    if (!isKnown(body_poses, pair)) {
      continue;
    }
    const double bound = boundDistance(setup, body_poses, pair);
    if (bound < least) {
      least = bound;
      guess = idAt<PairId>(i);
      found = true;
    }
  }
  return found;
}

/// Measures what may be nearer than `best`, except what was refined: its distances are known.
PairDistance searchClosest(const CycleSetup& setup, const BodyPoses& body_poses,
                           const RefineWork& refined, PairDistance best) noexcept {
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    const BodyPair& pair = setup.table.pairs()[i];
    if (!isKnown(body_poses, pair) || refined.is_measured[setup.element_pair_of[i]] != 0 ||
        boundDistance(setup, body_poses, pair) >= best.measured.distance) {
      continue;
    }
    const PairDistance candidate = measurePair(setup, body_poses, idAt<PairId>(i));
    if (candidate.measured.distance < best.measured.distance) {
      best = candidate;
    }
  }
  return best;
}

bool isNearer(const PairDistance& one, const PairDistance& other) noexcept {
  return one.measured.distance < other.measured.distance;
}

}  // namespace

void measurePairs(const CycleSetup& setup, const BodyPoses& body_poses,
                  const std::vector<PairId>& pairs, PairDistances& distances) noexcept {
  distances.measured.clear();
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

void measureClosest(const CycleSetup& setup, const BodyPoses& body_poses, const RefineWork& refined,
                    double reach, PairDistances& distances) noexcept {
  auto& measured = distances.measured;
  const auto nearest = std::min_element(measured.begin(), measured.end(), isNearer);
  PairId guess{};
  if ((nearest != measured.end() && nearest->measured.distance <= reach) ||
      (nearest == measured.end() && !guessClosest(setup, body_poses, guess))) {
    return;
  }
  const PairDistance start =
      nearest != measured.end() ? *nearest : measurePair(setup, body_poses, guess);
  const PairDistance closest = searchClosest(setup, body_poses, refined, start);
  const auto place = std::lower_bound(
      measured.begin(), measured.end(), closest.pair,
      [](const PairDistance& distance, PairId pair) { return distance.pair < pair; });
  if (place == measured.end() || place->pair != closest.pair) {
    measured.insert(place, closest);
  }
}

}  // namespace collision_monitor
