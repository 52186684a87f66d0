// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/states/state_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "pipeline/blocks/contact_of_pairs.h"
#include "pipeline/refine/touch_elements.h"

namespace collision_monitor {
namespace {

bool areConvex(const CycleSetup& setup, ElementPairIndex pair) noexcept {
  const ElementPair& elements = setup.element_pairs[pair];
  return setup.elements[index(elements.a)].convex && setup.elements[index(elements.b)].convex;
}

PlacedElement placed(const StateSearch& state, ElementId id) noexcept {
  StatesRefinement& refinement = state.refinement();
  const std::size_t i = index(id);
  if (refinement.placed_in[i] != refinement.state) {
    const LinkPlace& place = refinement.places[i];
    refinement.world_from_element[i] =
        place.frame == MovingFrame::kWorld
            ? place.frame_from_link
            : poseOf(state.work.frames[place.frame], state.lane) * place.frame_from_link;
    refinement.placed_in[i] = refinement.state;
  }
  return {state.setup.elements[i], refinement.world_from_element[i]};
}

ElementSearch searchFor(const StateSearch& state, ElementPairIndex pair, double cutoff) noexcept {
  StatesRefinement& refinement = state.refinement();
  RefineMemory& memory = refinement.memory.of(pair);
  if (refinement.is_independent && refinement.searched_in[pair] != refinement.state) {
    forget(memory.warm);
    memory.nearest = TrianglePair();
    memory.held = kNone;
    memory.triangles_meet = ContactForecast();
    refinement.searched_in[pair] = refinement.state;
  }
  ElementSearch search{std::numeric_limits<std::uint32_t>::max(), memory, *refinement.scratch,
                       cutoff};
  search.stands_alone = true;
  return search;
}

bool isTouching(const StateSearch& state, const ElementsInState& pair) noexcept {
  const ElementPair& elements = state.setup.element_pairs[pair.elements];
  ElementSearch search = searchFor(state, pair.elements, kInfinity);
  const ElementContact found =
      touchElements(placed(state, elements.a), placed(state, elements.b),
                    contactAlone(contactOfElements(state.setup, pair.elements)), search);
  // If contact is unknown, the enclosing shapes decide, which touch.
  return found.state != ElementContact::State::apart;
}

StateCheck checkOf(const ElementsInState& pair, double distance, Quality quality) noexcept {
  StateCheck check;
  check.has_pair = true;
  check.pair = idAt<PairId>(pair.bodies);
  check.distance = distance;
  check.quality = quality;
  return check;
}

/// The distance of two elements, or the bound of their bodies if that is larger.
StateCheck measure(const StateSearch& state, const ElementsInState& pair, double cutoff) noexcept {
  StateCheck check = checkOf(pair, pair.bound, Quality::lower_bound);
  if (areBodies(state.setup, pair.elements)) {
    const BodyPair& bodies = state.setup.table[check.pair];
    const bool are_exact = state.setup.bodies[index(bodies.a)].is_exact &&
                           state.setup.bodies[index(bodies.b)].is_exact;
    check.quality = are_exact ? Quality::exact : Quality::lower_bound;
    return check;
  }
  const ElementPair& elements = state.setup.element_pairs[pair.elements];
  ElementSearch search = searchFor(state, pair.elements, cutoff);
  const ElementDistance found =
      measureElements(placed(state, elements.a), placed(state, elements.b), search);
  const bool is_nearer = !(found.measured.distance > pair.bound);
  // Shapes that overlap give the depth of one pair of shapes: it does not bound the elements'.
  const bool is_depth = found.has_points && pair.bound < 0.0;
  if (found.quality != Quality::unknown &&
      !(found.quality == Quality::lower_bound && is_nearer && !is_depth)) {
    check.quality = found.quality;
    check.distance = found.measured.distance;
  }
  return check;
}

/// [m] At or below this distance the pair is in contact.
double contactDistanceOf(const StateSearch& state, const ElementsInState& pair) noexcept {
  return areBodies(state.setup, pair.elements)
             ? state.work.pairs[pair.bodies].contact_distance
             : limitsOf(state.setup, state.setup.link_pair_of[pair.bodies]).contact_distance;
}

Verdict verdictOf(const StateSearch& state, const ElementsInState& pair,
                  const StateCheck& check) noexcept {
  return check.quality == Quality::estimate || check.distance <= contactDistanceOf(state, pair)
             ? Verdict::contact
         : check.distance <= state.work.pairs[pair.bodies].warning_distance ? Verdict::warning
                                                                            : Verdict::clear;
}

/// Pairs last in contact come first, then pairs of deepest bodies.
bool comesFirst(const ElementsInState& one, const ElementsInState& other) noexcept {
  return std::tie(other.touched, one.bound, one.elements) <
         std::tie(one.touched, other.bound, other.elements);
}

/// Gives overlapping geometries no depth.
StateCheck contactCheck(const StateSearch& state, const ElementsInState& pair) noexcept {
  StateCheck check = isExact(state.setup, pair.elements) ? checkOf(pair, 0.0, Quality::estimate)
                                                         : measure(state, pair, kInfinity);
  check.verdict = Verdict::contact;
  return check;
}

/// Whether the depth or distance of a pair may be less than the best.
bool mayBeNearer(const StateSearch& state, const ElementsInState& pair,
                 const StateCheck& best) noexcept {
  // Depths of concave geometries are not needed.
  return pair.bound < best.distance &&
         (best.distance > 0.0 || areConvex(state.setup, pair.elements));
}

/// [m] Up to this distance the pair may make the verdict worse, though it is not the nearest. Only
/// limits of its own can cause that.
double worseWithin(const StateSearch& state, const ElementsInState& pair,
                   const StateCheck& best) noexcept {
  return state.setup.own_limits.empty() || best.verdict >= Verdict::warning
             ? -kInfinity
             : state.work.pairs[pair.bodies].warning_distance;
}

bool matters(const StateSearch& state, const ElementsInState& pair,
             const StateCheck& best) noexcept {
  return mayBeNearer(state, pair, best) || pair.bound <= worseWithin(state, pair, best);
}

/// [m] A search for the distance of a pair may end beyond this: there it is neither nearer than the
/// best, nor makes the verdict worse. A bound that ends the search is judged like a distance.
double cutoffOf(const StateSearch& state, const ElementsInState& pair,
                const StateCheck& best) noexcept {
  constexpr double kNotTouching = 1e-3;
  const double judged = std::max(worseWithin(state, pair, best), contactDistanceOf(state, pair));
  return std::max({best.distance, kNotTouching, std::nextafter(judged, kInfinity)});
}

/// Takes what is nearer or worse.
void take(const StateSearch& state, const ElementsInState& pair, StateCheck found,
          StateCheck& best) noexcept {
  found.verdict = std::max(best.verdict, verdictOf(state, pair, found));
  best.verdict = found.verdict;
  best = found.distance < best.distance ? found : best;
}

/// Measures a pair by the hulls of its geometries. If they give the distance, it is taken; else
/// they may raise the bound. @return whether it is taken
bool takeByHulls(const StateSearch& state, ElementsInState& pair, StateCheck& best) noexcept {
  pair.is_raised = true;
  if (areConvex(state.setup, pair.elements)) {
    return false;
  }
  const ElementPair& elements = state.setup.element_pairs[pair.elements];
  ElementSearch search = searchFor(state, pair.elements, cutoffOf(state, pair, best));
  const ElementDistance found =
      measureByHulls(placed(state, elements.a), placed(state, elements.b), search);
  if (found.quality == Quality::unknown) {
    return false;
  }
  pair.bound = std::max(pair.bound, found.measured.distance);
  if (found.quality == Quality::exact) {
    take(state, pair, checkOf(pair, found.measured.distance, Quality::exact), best);
  }
  return found.quality == Quality::exact;
}

/// Measures a pair by hulls, or the next time by its geometries. @return whether it is measured
bool takeNext(const StateSearch& state, ElementsInState& pair, StateCheck& best) noexcept {
  if (!pair.is_raised) {
    return takeByHulls(state, pair, best);
  }
  take(state, pair, measure(state, pair, cutoffOf(state, pair, best)), best);
  return true;
}

/// For heaps, whose first is the largest.
bool isFarther(const ElementsInState& one, const ElementsInState& other) noexcept {
  return std::tie(other.bound, other.elements) < std::tie(one.bound, one.elements);
}

}  // namespace

bool findContact(const StateSearch& state, StateCheck& check) noexcept {
  StatesRefinement& refinement = state.refinement();
  std::sort(refinement.pairs.begin(), refinement.pairs.end(), comesFirst);
  for (const ElementsInState& pair : refinement.pairs) {
    if (!(pair.bound > state.work.pairs[pair.bodies].contact_distance) &&
        (areBodies(state.setup, pair.elements) || isTouching(state, pair))) {
      if (!refinement.is_independent) {
        refinement.touched[pair.elements] = refinement.state;
        putFirst(pair.elements, refinement.order);
      }
      check = contactCheck(state, pair);
      return true;
    }
  }
  return false;
}

StateCheck measureConvex(const StateSearch& state, const StateCheck& bodies) noexcept {
  ElementsInState pair;
  pair.elements = state.setup.element_pair_of[index(bodies.pair)];
  pair.bodies = static_cast<std::uint32_t>(index(bodies.pair));
  pair.bound = bodies.distance;
  if (!areConvex(state.setup, pair.elements)) {
    return {};
  }
  StateCheck found = measure(state, pair, kInfinity);
  found.verdict = verdictOf(state, pair, found);
  return found.quality == Quality::exact ? found : StateCheck();
}

void findNearest(const StateSearch& state, StateCheck& best) noexcept {
  const bool is_measured = best.has_pair && best.quality == Quality::exact;
  const ElementPairIndex known =
      is_measured ? state.setup.element_pair_of[index(best.pair)] : ElementPairIndex(kNone);
  // The pair of the least bound comes first. Hulls raise a bound only when its turn comes, and
  // triangles are searched only if it comes again.
  std::vector<ElementsInState>& pairs = state.refinement().pairs;
  std::make_heap(pairs.begin(), pairs.end(), isFarther);
  for (auto end = pairs.end(); end != pairs.begin();) {
    std::pop_heap(pairs.begin(), end, isFarther);
    ElementsInState& pair = *(end - 1);
    if (pair.elements == known) {
      --end;
      continue;
    }
    if (state.setup.own_limits.empty() && !(pair.bound < best.distance)) {
      return;  // nor is any that is left
    }
    if (!matters(state, pair, best) || takeNext(state, pair, best)) {
      --end;
    } else {
      std::push_heap(pairs.begin(), end, isFarther);
    }
  }
}

}  // namespace collision_monitor
