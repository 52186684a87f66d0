// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/trajectory/link_pair_distance.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "geometry/constants.h"
#include "narrow_phase/distance.h"
#include "pipeline/blocks/contact_of_pairs.h"
#include "pipeline/data/motion_bound.h"
#include "pipeline/refine/measure_elements.h"

namespace collision_monitor {
namespace {

PairDistance nothingNear() noexcept {
  PairDistance distance;
  distance.measured.distance = std::numeric_limits<double>::infinity();
  return distance;
}

/// Replaces `nearest` by the distance of two bodies if that is less.
void improveByBodies(LinkPairMeasures& measures, PairId pair,
                     const std::vector<Pose>& world_from_link, PairDistance& nearest) noexcept {
  const CycleSetup& setup = measures.setup;
  const Body& a = setup.bodies[index(setup.table[pair].a)];
  const Body& b = setup.bodies[index(setup.table[pair].b)];
  const Pose& world_from_a = world_from_link[index(a.link)];
  const Pose& world_from_b = world_from_link[index(b.link)];
  const double reach = nearest.measured.distance + a.bounding_radius + b.bounding_radius;
  const double between =
      (world_from_a * a.link_from_body.translation - world_from_b * b.link_from_body.translation)
          .squaredNorm();
  if (reach < 0.0 || between > reach * reach) {
    return;
  }
  ++measures.work;
  const SignedDistance measured = distanceBetween(a.shape, world_from_a * a.link_from_body, b.shape,
                                                  world_from_b * b.link_from_body);
  if (measured.distance < nearest.measured.distance) {
    nearest = {pair, a.is_exact && b.is_exact ? Quality::exact : Quality::lower_bound, false,
               measured};
  }
}

struct PairIds {
  const PairId* first;
  const PairId* last;
  const PairId* begin() const noexcept { return first; }
  const PairId* end() const noexcept { return last; }
};

PairIds bodyPairsOf(const LinkPairMeasures& measures, LinkPairIndex pair) noexcept {
  const PairId* all = measures.body_pairs.data();
  return {all + measures.first_body_pair[pair], all + measures.first_body_pair[pair + 1]};
}

/// The cutoff and the kind of a measurement.
struct Question {
  double cutoff;
  ElementDistance (&measure)(const PlacedElement& a, const PlacedElement& b,
                             ElementSearch& search) noexcept;
};

bool areBodies(const CycleSetup& setup, const ElementPair& pair) noexcept {
  return setup.elements[index(pair.a)].is_body && setup.elements[index(pair.b)].is_body;
}

/// @pre the elements are not their bodies.
ElementDistance searchElements(LinkPairMeasures& measures, ElementPairIndex pair,
                               const std::vector<Pose>& world_from_link,
                               const Question& question) noexcept {
  const CycleSetup& setup = measures.setup;
  const Element& a = setup.elements[index(setup.element_pairs[pair].a)];
  const Element& b = setup.elements[index(setup.element_pairs[pair].b)];
  const Pose world_from_a = world_from_link[index(a.link)] * a.link_from_element;
  const Pose world_from_b = world_from_link[index(b.link)] * b.link_from_element;
  ElementSearch search{std::numeric_limits<std::uint32_t>::max(), measures.memory.of(pair),
                       *measures.scratch, question.cutoff};
  ElementDistance found = question.measure({a, world_from_a}, {b, world_from_b}, search);
  measures.work += found.work;
  measures.outside = std::min(measures.outside, found.outside);
  return found;
}

/// What was found of two elements, or the distance of their bodies if that is the better bound.
PairDistance betterOf(const ElementDistance& found, PairDistance distance) noexcept {
  const bool is_nearer = !(found.measured.distance > distance.measured.distance);
  // As in refinePairs: the depth of bodies is no bound.
  const bool is_depth = found.has_points && distance.measured.distance < 0.0;
  if (found.quality == Quality::unknown ||
      (found.quality == Quality::lower_bound && is_nearer && !is_depth)) {
    return distance;  // the enclosing shapes give the better bound
  }
  if (found.has_points) {
    return {distance.pair, found.quality, true, found.measured};
  }
  distance.measured.distance = found.measured.distance;
  return distance;
}

/// The distance of two elements, or that of their bodies if that is the better bound.
PairDistance measureElementPair(LinkPairMeasures& measures, ElementPairIndex pair,
                                const PairDistance& bodies,
                                const std::vector<Pose>& world_from_link,
                                const Question& question) noexcept {
  return areBodies(measures.setup, measures.setup.element_pairs[pair])
             ? bodies
             : betterOf(searchElements(measures, pair, world_from_link, question), bodies);
}

/// The same of two links for which asksElementsFirst. Measures bodies only if the elements tell
/// nothing. Else `pair` is any of theirs.
PairDistance measureOneElement(LinkPairMeasures& measures, LinkPairIndex pair,
                               const std::vector<Pose>& world_from_link,
                               const Question& question) noexcept {
  const ElementPairIndex elements = measures.first_element_pair[pair];
  ElementDistance found;
  if (!areBodies(measures.setup, measures.setup.element_pairs[elements])) {
    found = searchElements(measures, elements, world_from_link, question);
    const bool is_told =
        found.quality == Quality::lower_bound ? found.measured.distance > 0.0 : found.has_points;
    if (is_told) {
      const PairId bodies = measures.body_pairs[measures.first_body_pair[pair]];
      return {bodies, found.quality, found.has_points, found.measured};
    }
  }
  measureBodies(measures, pair, world_from_link);
  return betterOf(found, measures.nearest_bodies[0]);
}

/// Whether elements whose bodies are `bodies` apart may be nearer than `nearest`, or prove an
/// overlap where `nearest` does not.
bool mayTellMore(const PairDistance& bodies, const PairDistance& nearest) noexcept {
  return bodies.measured.distance < nearest.measured.distance ||
         (bodies.measured.distance <= 0.0 && nearest.quality != Quality::estimate);
}

/// Once an overlap is an estimate, a deeper distance is an estimate, too.
void addTo(PairDistance& nearest, const PairDistance& distance) noexcept {
  const bool was_estimate = nearest.quality == Quality::estimate;
  const bool is_estimate = distance.quality == Quality::estimate;
  const bool is_nearer = distance.measured.distance < nearest.measured.distance;
  if (was_estimate ? is_nearer && distance.quality != Quality::lower_bound
                   : is_nearer || (is_estimate && nearest.quality == Quality::lower_bound)) {
    nearest = distance;
  }
  if (was_estimate || is_estimate) {
    nearest.quality = Quality::estimate;
  }
}

/// The first index of each group if members are sorted by group, and the end of the last.
std::vector<std::uint32_t> startsOf(const std::vector<std::uint32_t>& group_of,
                                    std::size_t group_count) {
  std::vector<std::uint32_t> starts(group_count + 1, 0);
  for (const std::uint32_t group : group_of) {
    ++starts[group + 1];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  return starts;
}

/// The kinds of memories, without fronts and depths, which only cycles use.
std::vector<RefineKind> kindsOf(const CycleSetup& setup) {
  std::vector<RefineKind> kinds;
  kinds.reserve(setup.element_pairs.size());
  for (const ElementPair& pair : setup.element_pairs) {
    kinds.push_back(areBodies(setup, pair) ? RefineKind::never : RefineKind::plain);
  }
  return kinds;
}

std::vector<std::uint32_t> linkPairsOf(const std::vector<ElementPair>& pairs) {
  std::vector<std::uint32_t> link_pairs;
  link_pairs.reserve(pairs.size());
  for (const ElementPair& pair : pairs) {
    link_pairs.push_back(pair.link_pair);
  }
  return link_pairs;
}

}  // namespace

bool asksElementsFirst(const LinkPairMeasures& measures, LinkPairIndex pair) noexcept {
  const std::vector<Element>& elements = measures.setup.elements;
  const ElementPairIndex first = measures.first_element_pair[pair];
  if (measures.first_element_pair[pair + 1] - first != 1) {
    return false;
  }
  const ElementPair& only = measures.setup.element_pairs[first];
  return elements[index(only.a)].is_exact && elements[index(only.b)].is_exact;
}

LinkPairMeasures::LinkPairMeasures(const CycleSetup& cycle_setup)
    : setup(cycle_setup),
      balls(linkBalls(cycle_setup)),
      first_body_pair(startsOf(cycle_setup.link_pair_of, cycle_setup.checked.size())),
      body_pairs(cycle_setup.table.size()),
      first_element_pair(
          startsOf(linkPairsOf(cycle_setup.element_pairs), cycle_setup.checked.size())),
      has_meshes(cycle_setup.checked.size(), 0),
      memory(kindsOf(cycle_setup)),
      scratch(std::make_unique<RefineScratch>()) {
  std::vector<std::uint32_t> next = first_body_pair;
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    body_pairs[next[setup.link_pair_of[i]]++] = idAt<PairId>(i);
  }
  std::uint32_t most = 0;
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    most = std::max(most, first_element_pair[i + 1] - first_element_pair[i]);
  }
  nearest_bodies.resize(most);
  for (const ElementPair& pair : setup.element_pairs) {
    const bool are_convex =
        setup.elements[index(pair.a)].convex && setup.elements[index(pair.b)].convex;
    has_meshes[pair.link_pair] |= are_convex ? 0U : 1U;
  }
}

PairDistance bodyDistance(LinkPairMeasures& measures, LinkPairIndex pair,
                          const std::vector<Pose>& world_from_link) noexcept {
  PairDistance nearest = nothingNear();
  for (const PairId bodies : bodyPairsOf(measures, pair)) {
    improveByBodies(measures, bodies, world_from_link, nearest);
  }
  return nearest;
}

void measureBodies(LinkPairMeasures& measures, LinkPairIndex pair,
                   const std::vector<Pose>& world_from_link) noexcept {
  const ElementPairIndex first = measures.first_element_pair[pair];
  std::fill_n(measures.nearest_bodies.begin(), measures.first_element_pair[pair + 1] - first,
              nothingNear());
  for (const PairId bodies : bodyPairsOf(measures, pair)) {
    const ElementPairIndex elements = measures.setup.element_pair_of[index(bodies)];
    improveByBodies(measures, bodies, world_from_link, measures.nearest_bodies[elements - first]);
  }
}

PairDistance elementPairDistance(LinkPairMeasures& measures, ElementPairIndex pair,
                                 const PairDistance& bodies,
                                 const std::vector<Pose>& world_from_link, double cutoff) noexcept {
  return measureElementPair(measures, pair, bodies, world_from_link, {cutoff, measureElements});
}

PairDistance hullDistance(LinkPairMeasures& measures, LinkPairIndex pair,
                          const std::vector<Pose>& world_from_link, double cutoff) noexcept {
  const ElementPairIndex first = measures.first_element_pair[pair];
  const ElementPairIndex last = measures.first_element_pair[pair + 1];
  if (asksElementsFirst(measures, pair)) {
    return measureOneElement(measures, pair, world_from_link, {cutoff, measureByHulls});
  }
  measureBodies(measures, pair, world_from_link);
  PairDistance nearest = nothingNear();
  for (ElementPairIndex elements = first; elements < last; ++elements) {
    const PairDistance& bodies = measures.nearest_bodies[elements - first];
    if (bodies.measured.distance < nearest.measured.distance) {
      const PairDistance found =
          measureElementPair(measures, elements, bodies, world_from_link, {cutoff, measureByHulls});
      nearest = found.measured.distance < nearest.measured.distance ? found : nearest;
    }
  }
  return nearest;
}

PairDistance elementDistance(LinkPairMeasures& measures, LinkPairIndex pair,
                             const std::vector<Pose>& world_from_link, double cutoff) noexcept {
  const ElementPairIndex first = measures.first_element_pair[pair];
  const ElementPairIndex last = measures.first_element_pair[pair + 1];
  const auto addToLeeway = [&](ElementPairIndex elements, const PairDistance& found) {
    const double apart = found.quality == Quality::estimate ? -kInfinity : found.measured.distance;
    measures.leeway =
        std::min(measures.leeway, apart - contactOfElements(measures.setup, elements));
  };
  measures.leeway = measures.outside = kInfinity;
  if (asksElementsFirst(measures, pair)) {
    PairDistance found =
        measureOneElement(measures, pair, world_from_link, {cutoff, measureElements});
    addToLeeway(first, found);
    return found;
  }
  measureBodies(measures, pair, world_from_link);
  PairDistance nearest = nothingNear();
  for (ElementPairIndex elements = first; elements < last; ++elements) {
    const PairDistance& bodies = measures.nearest_bodies[elements - first];
    const double contact = contactOfElements(measures.setup, elements);
    if (mayTellMore(bodies, nearest) || bodies.measured.distance - contact < measures.leeway) {
      const PairDistance found = measureElementPair(measures, elements, bodies, world_from_link,
                                                    {cutoff, measureElements});
      addToLeeway(elements, found);
      addTo(nearest, found);
    }
  }
  return nearest;
}

}  // namespace collision_monitor
