// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <variant>

#include "geometry/constants.h"
#include "motion/convex_clearance.h"
#include "motion/mesh_clearance.h"
#include "pipeline/refine/element_parts.h"
#include "pipeline/trajectory/trajectory_search.h"

namespace collision_monitor {
namespace {

/// How two links move, each seen from the other.
struct LinkMotion {
  RelativeMotion of_b;
  RelativeMotion of_a;
};

LinkMotion motionOf(const TrajectorySearch& search, LinkPairIndex pair, const Instant& middle,
                    const std::vector<JointStep>& steps) {
  const LinkChain& chain = search.chains[pair];
  const std::vector<Ball>& balls = search.measures.balls;
  LinkMotion links{relativeMotion(chain, balls, middle.world_from_link, steps),
                   relativeMotion(reversed(chain), balls, middle.world_from_link, steps)};
  links.of_b.deviation_of_a = links.of_a.deviation;
  links.of_a.deviation_of_a = links.of_b.deviation;
  return links;
}

/// Two elements in the middle of a part.
struct PlacedElements {
  const Element& a;
  const Element& b;
  Pose world_from_a;
  Pose world_from_b;
};

PlacedElements placedAt(const CycleSetup& setup, ElementPairIndex pair,
                        const Instant& at) noexcept {
  const Element& a = setup.elements[index(setup.element_pairs[pair].a)];
  const Element& b = setup.elements[index(setup.element_pairs[pair].b)];
  return {a, b, at.world_from_link[index(a.link)] * a.link_from_element,
          at.world_from_link[index(b.link)] * b.link_from_element};
}

/// [m] How far the hulls stay apart, as clearanceOf. A half space is what motions are seen from.
double clearanceOfHulls(const PlacedElements& pair, const LinkMotion& links,
                        ConvexSearch& search) noexcept {
  const PlacedConvex a{hullOf(pair.a), pair.world_from_a};
  const PlacedConvex b{hullOf(pair.b), pair.world_from_b};
  if (std::holds_alternative<HalfSpace>(b.geometry)) {
    ConvexWarmStart swapped;
    ConvexSearch anew{search.workspace, swapped};
    return clearanceOf(b, a, links.of_a, anew);
  }
  return clearanceOf(a, b, links.of_b, search);
}

/// Asks meshes, seen from the one from which the motion is straighter.
MeshClearance askMeshes(const PlacedElements& pair, const LinkMotion& links, double distance,
                        MeshQueryMemory& memory) noexcept {
  const PlacedMesh a{*pair.a.mesh, pair.world_from_a};
  const PlacedMesh b{*pair.b.mesh, pair.world_from_b};
  return links.of_a.deviation < links.of_b.deviation
             ? stayApart(b, a, links.of_a, distance, memory)
             : stayApart(a, b, links.of_b, distance, memory);
}

/// Whether a mesh tells where an element is inside an open mesh, as measureElements finds it. Of a
/// simple solid any point may be inside, such as the middle of a bar that sticks out at both ends
/// of a channel. A mesh around it has only its corners to tell.
bool tellsWhatIsInside(const Element& element, const Element& other) noexcept {
  const bool is_simple = element.convex && !std::holds_alternative<ConvexHull>(*element.convex);
  return !is_simple || !other.mesh->openSurface();
}

/// Whether the meshes of two elements prove that they stay apart.
bool haveMeshes(const Element& a, const Element& b) noexcept {
  return !(a.convex && b.convex) && a.mesh && b.mesh && tellsWhatIsInside(a, b) &&
         tellsWhatIsInside(b, a);
}

/// [m] How far two elements stay apart, if more than `distance`.
double clearanceBeyond(double distance, const PlacedElements& pair, const LinkMotion& links,
                       Level level, RefineMemory& kept, LinkPairMeasures& measures) noexcept {
  const double paddings = pair.a.padding + pair.b.padding;
  const bool have_meshes = haveMeshes(pair.a, pair.b);
  double clearance = -kInfinity;
  if (!have_meshes || level < Level::elements) {
    ConvexSearch convex{measures.scratch->convex, kept.warm};
    ++measures.work;
    clearance = clearanceOfHulls(pair, links, convex) - paddings;
  }
  if (have_meshes && !(clearance > distance)) {
    const MeshClearance found = askMeshes(pair, links, distance + paddings, measures.scratch->mesh);
    measures.work += found.visits;
    clearance = found.is_proven ? found.at_least - paddings : -kInfinity;
  }
  return clearance;
}

}  // namespace

void placeMiddle(TrajectorySearch& search, const Instant& begin, const Instant& end,
                 Halving& halving) {
  if (halving.is_placed) {
    return;
  }
  halving.is_placed = true;
  halving.middle.segment = begin.segment;
  halving.middle.share = 0.5 * (begin.share + end.share);
  place(search, *halving.pairs, halving.middle);
  for (std::size_t i = 0; i < halving.steps.size(); ++i) {
    halving.steps[i] = stepOf(search.path, {begin.segment, begin.share, end.share}, i);
  }
}

bool settleMoving(TrajectorySearch& search, LinkPairIndex pair, Level level, const Instant& middle,
                  const std::vector<JointStep>& steps) {
  LinkPairMeasures& measures = search.measures;
  const LinkMotion links = motionOf(search, pair, middle, steps);
  const double distance = cutoffOf(search, pair);
  double at_least = kInfinity;
  for (ElementPairIndex i = measures.first_element_pair[pair];
       i < measures.first_element_pair[pair + 1]; ++i) {
    const double clearance = clearanceBeyond(distance, placedAt(search.setup, i, middle), links,
                                             level, measures.memory.of(i), measures);
    if (!(clearance > distance)) {  // also if it is no number
      return false;
    }
    at_least = std::min(at_least, clearance);
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
    return search.proven_by[pair] != Level::balls &&
           search.report.pairs[pair].state == ApproachState::clear;
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
           settleMoving(search, pair, search.proven_by[pair], at, range.steps);
  };
  range.open.erase(std::remove_if(range.open.begin(), range.open.end(), is_settled),
                   range.open.end());
}

}  // namespace collision_monitor
