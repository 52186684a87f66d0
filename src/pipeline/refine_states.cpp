// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "geometry/constants.h"
#include "pipeline/recall_elements.h"
#include "pipeline/state_elements.h"

namespace collision_monitor {
namespace {

/// @param asked [m] by state: changed to how far is to be asked for then
void findNearestOf(const CycleSetup& setup, StateNumber& asked, StatesWork& work,
                   std::array<StateCheck, kStateCount>& checks) noexcept {
  const NearQuery query{asked, 0, work.refinement.order.size()};
  for (std::size_t lane = 0; lane < kStateCount;) {
    const std::size_t end = lane + listNear(setup, query, lane, work);
    for (const std::size_t first = lane; lane < end; ++lane) {
      if (asked.of[lane] == kNotAsked) {
        continue;
      }
      ++work.refinement.state;
      const StateSearch state{setup, work, lane};
      const bool is_known = listElements(state, lane - first);
      findNearest(state, is_known, checks[lane]);
      forgetElements(work.refinement);
      const double distance = checks[lane].distance;
      asked.of[lane] = distance > asked.of[lane] && distance < kInfinity ? distance : kNotAsked;
    }
  }
}

/// What is as near as a warning mostly is the nearest. Else pairs are listed up to its distance.
void refineNearest(const CycleSetup& setup, const std::array<bool, kStateCount>& open,
                   StatesWork& work, std::array<StateCheck, kStateCount>& checks) noexcept {
  StateNumber asked;
  for (std::size_t lane = 0; lane < kStateCount; ++lane) {
    asked.of[lane] = open[lane] ? setup.limits.warning_distance : kNotAsked;
  }
  findNearestOf(setup, asked, work, checks);
  if (std::any_of(std::begin(asked.of), std::end(asked.of),
                  [](double distance) { return distance != kNotAsked; })) {
    findNearestOf(setup, asked, work, checks);
  }
}

/// Asks those states of one vector for a contact of some pairs, and closes them where one is found.
/// @return how many states that were
std::size_t findContacts(const CycleSetup& setup, const NearQuery& query, std::size_t first,
                         StateNumber& asked, StatesWork& work,
                         std::array<StateCheck, kStateCount>& checks) noexcept {
  const std::size_t count = listNear(setup, query, first, work);
  for (std::size_t place = 0; place < count; ++place) {
    const std::size_t lane = first + place;
    if (asked.of[lane] == kNotAsked) {
      continue;
    }
    ++work.refinement.state;
    const StateSearch state{setup, work, lane};
    if (!listElements(state, place)) {
      checks[lane].verdict = Verdict::unknown;
    }
    if (findContact(state, checks[lane])) {
      asked.of[lane] = kNotAsked;
    }
    forgetElements(work.refinement);
  }
  return count;
}

/// Those that were in contact last alone at first: mostly one of them is again.
void refineContacts(const CycleSetup& setup, const std::array<bool, kStateCount>& open,
                    StatesWork& work, std::array<StateCheck, kStateCount>& checks) noexcept {
  StateNumber asked;
  for (std::size_t lane = 0; lane < kStateCount; ++lane) {
    asked.of[lane] = open[lane] ? kContactsAsked : kNotAsked;
    if (open[lane]) {
      checks[lane] = StateCheck();
      checks[lane].verdict = Verdict::clear;
    }
  }
  const std::size_t all = work.refinement.order.size();
  const std::size_t few = std::min<std::size_t>(6, all);
  for (std::size_t lane = 0; lane < kStateCount;) {
    findContacts(setup, {asked, 0, few}, lane, asked, work, checks);
    lane += findContacts(setup, {asked, few, all}, lane, asked, work, checks);
  }
}

/// The pairs of bodies of each pair of elements, without those that are apart.
void listBodies(const CycleSetup& setup, const StatesWork& work, StatesRefinement& refinement) {
  refinement.element_pairs.resize(setup.element_pairs.size());
  std::vector<std::vector<std::uint32_t>> bodies(setup.element_pairs.size());
  for (std::uint32_t id = 0; id < setup.table.size(); ++id) {
    if (!work.pairs[id].is_apart) {
      bodies[setup.element_pair_of[id]].push_back(id);
    }
  }
  for (ElementPairIndex i = 0; i < setup.element_pairs.size(); ++i) {
    StateElementPair& pair = refinement.element_pairs[i];
    pair.a = static_cast<std::uint32_t>(index(setup.element_pairs[i].a));
    pair.b = static_cast<std::uint32_t>(index(setup.element_pairs[i].b));
    pair.radii = refinement.balls[pair.a].radius + refinement.balls[pair.b].radius;
    pair.contact_distance = std::max(0.0, setup.limits.contact_distance);
    pair.first = static_cast<std::uint32_t>(refinement.body_pairs.size());
    refinement.body_pairs.insert(refinement.body_pairs.end(), bodies[i].begin(), bodies[i].end());
    pair.last = static_cast<std::uint32_t>(refinement.body_pairs.size());
  }
}

void placeElements(const CycleSetup& setup, const KinematicsPlan& plan,
                   StatesRefinement& refinement) {
  for (const Element& element : setup.elements) {
    LinkPlace place = plan.links[index(element.link)];
    place.frame_from_link = place.frame_from_link * element.link_from_element;
    refinement.places.push_back(place);
    refinement.balls.push_back(ballOf(element));
    refinement.balls.back().radius += element.padding;
  }
  refinement.centers.resize(setup.elements.size());
  refinement.world_from_element.resize(setup.elements.size());
  refinement.placed_in.resize(setup.elements.size(), 0);
}

}  // namespace

StatesRefinement makeStatesRefinement(const CycleSetup& setup, const StatesWork& work) {
  StatesRefinement refinement;
  placeElements(setup, work.plan, refinement);
  listBodies(setup, work, refinement);
  std::vector<RefineKind> kinds;
  for (ElementPairIndex pair = 0; pair < setup.element_pairs.size(); ++pair) {
    kinds.push_back(areBodies(setup, pair) ? RefineKind::never : RefineKind::plain);
    refinement.order.push_back(pair);
  }
  refinement.memory = RefineStore(std::move(kinds));
  refinement.scratch = std::make_unique<RefineScratch>();
  refinement.near.reserve(setup.table.size());
  refinement.place_of.resize(setup.element_pairs.size(), kNone);
  refinement.pairs.reserve(setup.element_pairs.size());
  refinement.touched.resize(setup.element_pairs.size(), 0);
  return refinement;
}

void refineStates(const CycleSetup& setup, StateQuestion question,
                  const std::array<bool, kStateCount>& open, StatesWork& work,
                  std::array<StateCheck, kStateCount>& checks) noexcept {
  placeCenters(work);
  (question == StateQuestion::contact ? refineContacts : refineNearest)(setup, open, work, checks);
}

}  // namespace collision_monitor
