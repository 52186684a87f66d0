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
  return reach < 0.0 || squared_distance > reach * reach * (1.0 + kRounding);
}

bool orientedBoxesPart(const PosedPair& pair) noexcept {
  const BoxPair boxes = makeBoxPair(coreHalfExtents(pair.a.shape), pair.world_from_a,
                                    coreHalfExtents(pair.b.shape), pair.world_from_b);
  const double gap =
      separationsOfBoxes(boxes).largest - radiusOf(pair.a.shape) - radiusOf(pair.b.shape);
  return gap > pair.distance + toleranceOf(boxes);
}

}  // namespace

void cullCandidates(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  const std::vector<Pose>& poses = buffers.body_poses.world_from_body;
  const std::vector<double>& ahead = buffers.bounds.ahead;
  const std::vector<double>& way = buffers.sweep.body_reach;
  CycleCounters& counters = buffers.counters;
  counters.culled_by_spheres = 0;
  counters.culled_by_boxes = 0;
  const double reach = reachOf(setup.limits);
  const auto is_out_of_reach = [&](PairId id) {
    const std::size_t a = index(setup.table[id].a);
    const std::size_t b = index(setup.table[id].b);
    const double passed = setup.is_continuous ? way[a] + way[b] : 0.0;
    const double distance =
        std::max(reach + ahead[a] + ahead[b], setup.limits.contact_distance + passed);
    const PosedPair pair{setup.bodies[a], setup.bodies[b], poses[a], poses[b], distance};
    const bool spheres_part = spheresPart(pair);
    const bool boxes_part = !spheres_part && orientedBoxesPart(pair);
    counters.culled_by_spheres += spheres_part ? 1 : 0;
    counters.culled_by_boxes += boxes_part ? 1 : 0;
    return spheres_part || boxes_part;
  };
  std::vector<PairId>& candidates = buffers.candidates;
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_out_of_reach),
                   candidates.end());
}

}  // namespace collision_monitor
