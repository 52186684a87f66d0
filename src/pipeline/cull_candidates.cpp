// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "collision_monitor/pipeline/run_cycle.h"
#include "narrow_phase/separating_axes.h"

namespace collision_monitor {
namespace {

/// What a pair of bodies is asked.
struct PosedPair {
  const Body& a;
  const Body& b;
  const Pose& world_from_a;
  const Pose& world_from_b;
  double distance;  ///< [m] nearer pairs must stay
};

/// Without a root.
bool spheresPart(const PosedPair& pair) noexcept {
  constexpr double kRounding = 1e-12;
  const double reach = pair.a.bounding_radius + pair.b.bounding_radius + pair.distance;
  const double squared_distance =
      (pair.world_from_b.translation - pair.world_from_a.translation).squaredNorm();
  return (reach < 0.0) | (squared_distance > reach * reach * (1.0 + kRounding));
}

bool orientedBoxesPart(const PosedPair& pair) noexcept {
  const BoxPair boxes = makeBoxPair(coreHalfExtents(pair.a.shape), pair.world_from_a,
                                    coreHalfExtents(pair.b.shape), pair.world_from_b);
  const double gap =
      separationsOfBoxes(boxes).largest - radiusOf(pair.a.shape) - radiusOf(pair.b.shape);
  return gap > pair.distance + toleranceOf(boxes);
}

/// No branch: which of the candidates are left is hard to predict.
template <class IsFar>
void keepUnless(const IsFar& is_far, std::vector<PairId>& candidates) noexcept {
  std::size_t kept = 0;
  for (const PairId id : candidates) {
    candidates[kept] = id;
    kept += is_far(id) ? 0 : 1;
  }
  candidates.resize(kept);
}

}  // namespace

void cullCandidates(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  const std::vector<Pose>& poses = buffers.body_poses.world_from_body;
  const auto pairOf = [&](PairId id) -> PosedPair {
    const std::size_t a = index(setup.table[id].a);
    const std::size_t b = index(setup.table[id].b);
    return {setup.bodies[a], setup.bodies[b], poses[a], poses[b],
            buffers.reaches.of_pair[setup.link_pair_of[index(id)]]};
  };
  std::vector<PairId>& candidates = buffers.candidates;
  const std::size_t found = candidates.size();
  keepUnless([&](PairId id) { return spheresPart(pairOf(id)); }, candidates);
  buffers.counters.culled_by_spheres = found - candidates.size();
  if (buffers.culls_by_boxes) {
    keepUnless([&](PairId id) { return orientedBoxesPart(pairOf(id)); }, candidates);
  }
  buffers.counters.culled_by_boxes = found - buffers.counters.culled_by_spheres - candidates.size();
}

}  // namespace collision_monitor
