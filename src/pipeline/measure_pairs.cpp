// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "collision_monitor/narrow_phase/distance.h"
#include "collision_monitor/pipeline/run_cycle.h"

namespace collision_monitor {
namespace {

PairDistance measurePair(const CycleSetup& setup, const BodyPoses& body_poses, PairId id) noexcept {
  const BodyPair& pair = setup.table[id];
  const Body& a = setup.bodies[index(pair.a)];
  const Body& b = setup.bodies[index(pair.b)];
  PairDistance distance;
  distance.pair = id;
  distance.quality = a.is_exact && b.is_exact ? Quality::exact : Quality::lower_bound;
  distance.measured = distanceBetween(a.shape, body_poses.world_from_body[index(pair.a)], b.shape,
                                      body_poses.world_from_body[index(pair.b)]);
  return distance;
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
  for (const PairId pair : pairs) {
    distances.measured.push_back(measurePair(setup, body_poses, pair));
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
