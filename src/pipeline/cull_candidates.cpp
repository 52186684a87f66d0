// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "collision_monitor/pipeline/run_cycle.h"
#include "narrow_phase/separating_axes.h"

namespace collision_monitor {
namespace {

/// Without a root.
/// @param distance [m] nearer pairs must stay
bool ballsPart(const Ball& a, const Ball& b, double distance) noexcept {
  constexpr double kRounding = 1e-12;
  const double reach = a.radius + b.radius + distance;
  const double squared_distance = (b.center - a.center).squaredNorm();
  return (reach < 0.0) | (squared_distance > reach * reach * (1.0 + kRounding));
}

bool orientedBoxesPart(const CycleSetup& setup, const BodyPoses& poses, const BodyPair& pair,
                       double distance) noexcept {
  const std::size_t a = index(pair.a);
  const std::size_t b = index(pair.b);
  const BoxPair boxes = makeBoxPair(setup.cores[a].half_extents, poses.world_from_body[a],
                                    setup.cores[b].half_extents, poses.world_from_body[b]);
  const double gap =
      separationsOfBoxes(boxes).largest - setup.cores[a].radius - setup.cores[b].radius;
  return gap > distance + toleranceOf(boxes);
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
  const std::vector<Ball>& balls = buffers.body_poses.balls;
  const auto reachOfPair = [&](PairId id) {
    return buffers.reaches.of_pair[setup.link_pair_of[index(id)]];
  };
  std::vector<PairId>& candidates = buffers.candidates;
  const std::size_t found = candidates.size();
  const auto isFarByBalls = [&](PairId id) {
    const BodyPair& pair = setup.table[id];
    return ballsPart(balls[index(pair.a)], balls[index(pair.b)], reachOfPair(id));
  };
  keepUnless(isFarByBalls, candidates);
  buffers.counters.culled_by_spheres = found - candidates.size();
  if (buffers.culls_by_boxes) {
    const auto isFarByBoxes = [&](PairId id) {
      return orientedBoxesPart(setup, buffers.body_poses, setup.table[id], reachOfPair(id));
    };
    keepUnless(isFarByBoxes, candidates);
  }
  buffers.counters.culled_by_boxes = found - buffers.counters.culled_by_spheres - candidates.size();
}

}  // namespace collision_monitor
