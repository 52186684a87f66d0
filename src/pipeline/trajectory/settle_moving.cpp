// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "geometry/constants.h"
#include "motion/mesh_clearance.h"
#include "pipeline/trajectory/trajectory_search.h"

namespace collision_monitor {
namespace {

/// How two links move, seen from the one from which the motion is straighter.
struct LinkMotion {
  bool is_swapped;  ///< seen from the second
  RelativeMotion motion;
};

LinkMotion motionOf(const TrajectorySearch& search, LinkPairIndex pair, const Instant& middle,
                    const std::vector<JointStep>& steps) {
  const LinkChain& chain = search.chains[pair];
  const std::vector<Ball>& balls = search.measures.balls;
  RelativeMotion of_b = relativeMotion(chain, balls, middle.world_from_link, steps);
  RelativeMotion of_a = relativeMotion(reversed(chain), balls, middle.world_from_link, steps);
  of_b.deviation_of_a = of_a.deviation;
  of_a.deviation_of_a = of_b.deviation;
  return of_a.deviation < of_b.deviation ? LinkMotion{true, of_a} : LinkMotion{false, of_b};
}

}  // namespace

bool haveMeshes(const TrajectorySearch& search, LinkPairIndex pair) noexcept {
  const std::vector<Element>& elements = search.setup.elements;
  const ElementPair* pairs = search.setup.element_pairs.data();
  return std::all_of(pairs + search.measures.first_element_pair[pair],
                     pairs + search.measures.first_element_pair[pair + 1],
                     [&](const ElementPair& both) {
                       return elements[index(both.a)].mesh && elements[index(both.b)].mesh;
                     });
}

void placeMiddle(TrajectorySearch& search, const Instant& begin, const Instant& end,
                 Halving& halving) {
  if (halving.is_placed) {
    return;
  }
  halving.is_placed = true;
  halving.middle.segment = begin.segment;
  halving.middle.share = 0.5 * (begin.share + end.share);
  place(search, halving.middle);
  search.measures.work += halving.middle.world_from_link.size();
  for (std::size_t i = 0; i < halving.steps.size(); ++i) {
    halving.steps[i] = stepOf(search.path, {begin.segment, begin.share, end.share}, i);
  }
}

bool settleMoving(TrajectorySearch& search, LinkPairIndex pair, const Instant& middle,
                  const std::vector<JointStep>& steps) {
  LinkPairMeasures& measures = search.measures;
  const LinkMotion links = motionOf(search, pair, middle, steps);
  const double distance = cutoffOf(search, pair);
  double at_least = kInfinity;
  const auto stay_apart = [&](const ElementPair& elements) {
    const Element* a = &search.setup.elements[index(elements.a)];
    const Element* b = &search.setup.elements[index(elements.b)];
    if (links.is_swapped) {
      std::swap(a, b);
    }
    const Pose world_from_a = middle.world_from_link[index(a->link)] * a->link_from_element;
    const Pose world_from_b = middle.world_from_link[index(b->link)] * b->link_from_element;
    const double paddings = a->padding + b->padding;
    const MeshClearance found =
        stayApart({*a->mesh, world_from_a}, {*b->mesh, world_from_b}, links.motion,
                  distance + paddings, measures.scratch->mesh);
    measures.work += found.visits;
    at_least = std::min(at_least, found.at_least - paddings);
    return found.is_proven;
  };
  const ElementPair* elements = search.setup.element_pairs.data();
  if (!std::all_of(elements + measures.first_element_pair[pair],
                   elements + measures.first_element_pair[pair + 1], stay_apart)) {
    return false;
  }
  PairApproach& approach = search.report.pairs[pair];
  approach.at_least = std::min(approach.at_least, at_least);
  if (search.found[pair] < Found::elements) {
    PairDistance bound = bodyDistance(measures, pair, middle.world_from_link);
    bound.measured.distance = std::max(bound.measured.distance, at_least);
    bound.quality = Quality::lower_bound;
    keepNearest(search, pair, bound, middle, Found::bounds);
  }
  return true;
}

void settleClose(TrajectorySearch& search, std::size_t first, std::size_t middle, std::size_t last,
                 Halving& range) {
  const auto may_be_settled = [&](LinkPairIndex pair) {
    return search.is_close[pair] != 0 && search.report.pairs[pair].state == ApproachState::clear;
  };
  if (std::none_of(range.open.begin(), range.open.end(), may_be_settled)) {
    return;
  }
  for (std::size_t i = 0; i < range.steps.size(); ++i) {
    range.steps[i] = stepOf(search.path, search.first_stop + first, search.first_stop + middle,
                            search.first_stop + last, i);
  }
  const Instant& at = search.stops[middle];
  const auto is_settled = [&](LinkPairIndex pair) {
    return may_be_settled(pair) && goesOnWorking(search, at) &&
           settleMoving(search, pair, at, range.steps);
  };
  range.open.erase(std::remove_if(range.open.begin(), range.open.end(), is_settled),
                   range.open.end());
}

}  // namespace collision_monitor
