// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/touch_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/refine/element_parts.h"

namespace collision_monitor {
namespace {

using State = ElementContact::State;

// Work of other steps, in opened node pairs.
constexpr std::uint32_t kStartWork = 2;  // poses and last triangles
constexpr std::uint32_t kHullWork = 8;   // two convex geometries
constexpr std::uint32_t kInnerWork = 2;

ElementContact settled(State state, std::uint32_t work) noexcept {
  ElementContact found;
  found.state = state;
  found.work = work;
  found.is_complete = true;
  return found;
}

bool isHalfSpace(const PlacedElement& placed) noexcept {
  return std::holds_alternative<HalfSpace>(*placed.element.convex);
}

bool isCylinder(const PlacedElement& placed) noexcept {
  return std::holds_alternative<Cylinder>(*placed.element.convex);
}

/// Shapes have closed forms, and a half space has one with everything: their distance costs no more
/// than a contact test. @pre both are convex
bool haveClosedForm(const PlacedElement& a, const PlacedElement& b) noexcept {
  return isHalfSpace(a) || isHalfSpace(b) ||
         (shapeOf(a.element.convex) && shapeOf(b.element.convex));
}

ElementContact measureContact(const PlacedElement& a, const PlacedElement& b, double reach,
                              ElementSearch& search) noexcept {
  ConvexSearch convex{search.scratch.convex, search.memory.warm};
  const ConvexDistance found = signedDistanceBetween(
      *a.element.convex, a.world_from_element, *b.element.convex, b.world_from_element, convex);
  const State state = found.quality == Quality::unknown ? State::unknown
                      : found.measured.distance > reach ? State::apart
                                                        : State::contact;
  return settled(state, kHullWork);
}

enum class HullAnswer : unsigned char { apart, contact, open };

/// Asks what holds the geometries; `told` gets its work, and ElementContact::outside. Gives a
/// contact only if it is shown on the surfaces themselves.
HullAnswer askHulls(const PlacedElement& a, const PlacedElement& b, double reach,
                    bool is_measured_next, ElementSearch& search, ElementContact& told) noexcept {
  const double beyond = std::nextafter(reach, std::numeric_limits<double>::infinity());
  const MeshDistance found =
      distanceByHulls(heldSurfaceOf(a), heldSurfaceOf(b), {beyond, 0.0, is_measured_next},
                      search.scratch.mesh, {search.memory.warm, search.memory.nearest});
  told.work += kHullWork + found.visits;
  told.outside = found.outside;
  const bool is_told = found.state == MeshState::exact || found.state == MeshState::lower_bound;
  if (is_told && found.measured.distance > reach) {
    return HullAnswer::apart;
  }
  return found.state == MeshState::exact ? HullAnswer::contact : HullAnswer::open;
}

ElementContact touchConvex(const PlacedElement& a, const PlacedElement& b, double reach,
                           bool is_measured_next, ElementSearch& search) noexcept {
  if (reach < 0.0 || haveClosedForm(a, b)) {
    return measureContact(a, b, reach, search);
  }
  if (!isFinite(a.world_from_element) || !isFinite(b.world_from_element)) {
    return settled(State::unknown, 0);
  }
  if (search.stands_alone && (isCylinder(a) || isCylinder(b))) {
    forget(search.memory.warm);
  }
  ElementContact told;
  const bool is_apart = askHulls(a, b, reach, is_measured_next, search, told) == HullAnswer::apart;
  return settled(is_apart ? State::apart : State::contact, told.work);
}

bool overlapInside(const PlacedElement& a, const PlacedElement& b, double reach) noexcept {
  SignedDistance least;
  return measureInside(a, b, least) && least.distance <= reach;
}

ElementContact touchTriangles(const PlacedElement& a, const PlacedElement& b,
                              const ContactGoal& goal, double reach, std::uint32_t work,
                              ElementSearch& search) noexcept {
  TrianglePair& last = search.memory.nearest;
  MeshQueryMemory& memory = search.scratch.mesh;
  const MeshContactQuery query{
      reach,
      goal.asks_outside,
      goal.outside,
      search.budget - std::min(search.budget, work),
      search.memory.held,
      search.memory.front != nullptr ? search.memory.front->probes : KeptProbes()};
  const MeshContact found = isSimple(b)   ? contactOf(meshOf(a), convexOf(b), query, memory, last)
                            : isSimple(a) ? contactOf(meshOf(b), convexOf(a), query, memory, last)
                                          : contactOf(meshOf(a), meshOf(b), query, memory, last);
  if (found.state == MeshContact::State::contact && found.triangles.a != kNone) {
    last = found.triangles;
  }
  search.memory.held = found.held;
  ElementContact answer;
  answer.work = work + found.visits;
  answer.is_complete = found.state != MeshContact::State::open;
  answer.state = found.state == MeshContact::State::apart     ? State::apart
                 : found.state == MeshContact::State::contact ? State::contact
                                                              : State::unknown;
  answer.outside = found.outside;
  return answer;
}

/// What decides without triangles, the cheapest first. `told` gets the work so far.
bool decideWithoutTriangles(const PlacedElement& a, const PlacedElement& b, double reach,
                            bool is_measured_next, ElementSearch& search,
                            ElementContact& told) noexcept {
  const HullAnswer hulls = askHulls(a, b, reach, is_measured_next, search, told);
  const bool is_decided = hulls != HullAnswer::open || overlapInside(a, b, reach);
  told.work += hulls != HullAnswer::open ? 0 : kInnerWork;
  told.state = hulls == HullAnswer::apart ? State::apart : State::contact;
  told.is_complete = is_decided;
  return is_decided;
}

ElementContact touchConcave(const PlacedElement& a, const PlacedElement& b, const ContactGoal& goal,
                            double reach, ElementSearch& search) noexcept {
  constexpr std::uint32_t kFew = 64;  // less than the hulls take if two triangles meet soon
  ElementContact told;
  told.work = kStartWork;
  ContactForecast& forecast = search.memory.triangles_meet;
  if (forecast.isLikely() || search.memory.held != kNone) {
    ElementSearch brief = search;
    brief.budget = std::min(search.budget, kFew);
    const ElementContact found = touchTriangles(a, b, goal, reach, told.work, brief);
    if (found.is_complete) {
      forecast.add(found.state == State::contact);
      return found;
    }
    told.work = found.work;
  }
  if (decideWithoutTriangles(a, b, reach, goal.is_measured_next, search, told)) {
    forecast.add(false);
    return told;
  }
  const ElementContact found = touchTriangles(a, b, goal, reach, told.work, search);
  forecast.add(found.state == State::contact && found.work - told.work <= kFew);
  return found;
}

}  // namespace

ElementContact touchElements(const PlacedElement& a, const PlacedElement& b,
                             const ContactGoal& goal, ElementSearch& search) noexcept {
  const double paddings = a.element.padding + b.element.padding;
  if (a.element.convex && b.element.convex) {
    return touchConvex(a, b, goal.distance + paddings, goal.is_measured_next, search);
  }
  return touchConcave(a, b, goal, std::max(goal.distance + paddings, 0.0), search);
}

}  // namespace collision_monitor
