// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/link_distances.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/cycle/judge_pairs.h"
#include "pipeline/cycle/measure_pairs.h"
#include "pipeline/cycle/place_bodies.h"

namespace collision_monitor {
namespace {

void findNearest(const CycleSetup& setup, LinkDistances& links) noexcept {
  std::fill(links.nearest.begin(), links.nearest.end(), kNone);
  std::fill(links.estimated.begin(), links.estimated.end(), kNone);
  auto& measured = links.distances.pairs;
  const auto improve = [&](std::uint32_t one, std::uint32_t& best) {
    if (best == kNone || measured[one].measured.distance < measured[best].measured.distance) {
      best = one;
    }
  };
  for (std::uint32_t i = 0; i < measured.size(); ++i) {
    const std::uint32_t link_pair = setup.link_pair_of[index(measured[i].pair)];
    improve(i, links.nearest[link_pair]);
    if (measured[i].quality == Quality::estimate) {
      improve(i, links.estimated[link_pair]);
    }
  }
  for (const PairDistance& one : measured) {
    const std::uint32_t link_pair = setup.link_pair_of[index(one.pair)];
    preferEstimate(links.estimated[link_pair], measured, links.nearest[link_pair]);
  }
}

}  // namespace

LinkDistances makeLinkDistances(const CycleSetup& setup) {
  LinkDistances links;
  links.body_poses = makeBodyPoses(setup);
  links.candidates.reserve(setup.table.size());
  links.distances.pairs.reserve(setup.table.size());
  links.nearest.resize(setup.checked.size(), kNone);
  links.estimated.resize(setup.checked.size(), kNone);
  links.refine = makeRefineWork(setup);
  links.refine.limits = RefineLimits();
  links.refine.limits.budget = std::numeric_limits<std::uint32_t>::max();
  links.memory.refined = makeRefineMemory(setup);
  links.memory.starved_cycles.resize(setup.element_pairs.size(), 0);
  return links;
}

void placeAll(const CycleSetup& setup, const LinkPoses& poses, LinkDistances& links) noexcept {
  placeBodies(setup, poses, links.body_poses);
  placeElements(setup, poses, links.body_poses);
}

void measureWithin(const CycleSetup& setup, double distance, Asked asked,
                   LinkDistances& links) noexcept {
  measurePairs(setup, links.body_poses, links.candidates, links.distances);
  std::fill(links.refine.distances.begin(), links.refine.distances.end(), distance);
  links.refine.cutoff = std::nextafter(distance, std::numeric_limits<double>::infinity());
  links.refine.finds_nearest = asked == Asked::nearest;
  refinePairs(setup, links.body_poses, links.memory, links.refine, links.distances);
  findNearest(setup, links);
}

}  // namespace collision_monitor
