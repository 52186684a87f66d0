// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "pipeline/cycle/place_bodies.h"
#include "pipeline/refine/recall_elements.h"
#include "pipeline/states/state_elements.h"

namespace collision_monitor {
namespace {

/// Lists near pairs in the queried states of one vector, and visits each state. A query for any
/// contact passes over states without near pairs. @param visit takes the state and whether all
/// poses are finite. @return how many states the vector holds
template <class Visit>
std::size_t visitVector(const CycleSetup& setup, const NearQuery& query, std::size_t first,
                        StatesWork& work, const Visit& visit) noexcept {
  const std::size_t count = listNear(setup, query, first, work);
  const unsigned visited = query.asks_any ? work.refinement.have_near : ~0U;
  for (std::size_t place = 0; place < count; ++place) {
    if ((visited >> place & 1U) != 0 && query.asked.of[first + place] != kNotAsked) {
      ++work.refinement.state;
      const StateSearch state{setup, work, first + place};
      visit(state, listElements(state, place));
      forgetElements(work.refinement);
    }
  }
  return count;
}

template <class Visit>
void visitAll(const CycleSetup& setup, const NearQuery& query, StatesWork& work,
              const Visit& visit) noexcept {
  for (std::size_t lane = 0; lane < kStateCount;) {
    lane += visitVector(setup, query, lane, work, visit);
  }
}

/// [m] How far the next query reaches; kNotAsked if none is needed. If no pair of geometries was
/// found within reach, the next query reaches farther.
double nextReach(double reach, const StateCheck& check) noexcept {
  constexpr double kLeast = 0.01;
  constexpr double kMost = 1e4;
  constexpr double kRounding = 1e-12;  // [m] of a distance measured twice
  if (!check.has_pair) {
    const bool is_open = check.verdict != Verdict::unknown && reach < kMost;
    return is_open ? std::max(kLeast, 2.0 * reach) : kNotAsked;
  }
  const double rounding = kRounding * std::max(1.0, std::abs(reach));
  return check.distance > reach + rounding ? check.distance : kNotAsked;
}

/// @param asked [m] by state; then the distance of the next query, if one is needed
/// @param known by state: from measureConvex
void findNearestOf(const CycleSetup& setup, StateNumber& asked, const BlockChecks& known,
                   StatesWork& work, BlockChecks& checks) noexcept {
  const NearQuery query{asked, 0, work.refinement.order.size()};
  visitAll(setup, query, work, [&](const StateSearch& state, bool is_known) noexcept {
    StateCheck& check = checks[state.lane] = known[state.lane];
    if (!check.has_pair) {
      check.verdict = Verdict::clear;
      check.distance = kInfinity;
    }
    check.verdict = is_known ? check.verdict : std::max(check.verdict, Verdict::unknown);
    findNearest(state, check);
    asked.of[state.lane] = nextReach(asked.of[state.lane], check);
  });
}

/// Searches the queried states of one vector for a contact of some pairs; closes states with a
/// contact. @return how many states the vector holds
std::size_t findContacts(const CycleSetup& setup, const NearQuery& query, std::size_t first,
                         StateNumber& asked, StatesWork& work, BlockChecks& checks) noexcept {
  return visitVector(setup, query, first, work,
                     [&](const StateSearch& state, bool is_known) noexcept {
                       if (!is_known) {
                         checks[state.lane].verdict = Verdict::unknown;
                       }
                       if (findContact(state, checks[state.lane])) {
                         asked.of[state.lane] = kNotAsked;
                       }
                     });
}

/// [m] By ElementId: the radius of a ball around its bodies, with the center of its own ball. A
/// little more, so that rounding passes over no pair.
std::vector<double> radiiOfBodies(const CycleSetup& setup, const std::vector<Ball>& balls) {
  constexpr double kRounding = 1e-9;
  std::vector<double> radii(setup.elements.size(), 0.0);
  for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
    const Body& body = setup.bodies[i];
    const std::size_t element = index(body.element);
    const Eigen::Vector3d center =
        inverse(body.link_from_body) *
        (setup.elements[element].link_from_element * balls[element].center);
    const Core& core = setup.cores[i];
    const double farthest = (center.cwiseAbs() + core.half_extents).norm() + core.radius;
    radii[element] = std::max(radii[element], farthest + kRounding);
  }
  return radii;
}

/// Lists the pairs of bodies of each pair of elements, without those of unknown relative pose.
void listBodies(const CycleSetup& setup, const StatesWork& work, StatesRefinement& refinement) {
  refinement.element_pairs.resize(setup.element_pairs.size());
  const std::vector<double> radii = radiiOfBodies(setup, refinement.balls);
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
    pair.body_radii = radii[pair.a] + radii[pair.b];
    const bool is_a_larger = refinement.balls[pair.a].radius > refinement.balls[pair.b].radius;
    pair.ball = is_a_larger ? pair.b : pair.a;
    pair.box = refinement.box_of[is_a_larger ? pair.a : pair.b];
    pair.ball_box = refinement.box_of[pair.ball];
    pair.has_many = bodies[i].size() > 1 && pair.box != kNone && pair.ball_box != kNone;
    const Limits& limits = limitsOf(setup, setup.element_pairs[i].link_pair);
    pair.contact_distance = std::max(0.0, limits.contact_distance);
    pair.warning_distance = limits.warning_distance;
    pair.are_convex = setup.elements[pair.a].convex && setup.elements[pair.b].convex;
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
    // Of those that no joint moves this stays; others are placed for each block.
    fillAll(place.frame_from_link * refinement.balls.back().center,
            refinement.centers.emplace_back().of);
  }
  refinement.world_from_element.resize(setup.elements.size());
  refinement.placed_in.resize(setup.elements.size(), 0);
  refinement.body_placed_in.resize(setup.bodies.size(), 0);
}

}  // namespace

StatesRefinement makeStatesRefinement(const CycleSetup& setup, const StatesWork& work) {
  StatesRefinement refinement;
  placeElements(setup, work.plan, refinement);
  addBoxes(setup, work, refinement);
  listBodies(setup, work, refinement);
  std::vector<RefineKind> kinds;
  for (ElementPairIndex pair = 0; pair < setup.element_pairs.size(); ++pair) {
    kinds.push_back(areBodies(setup, pair) ? RefineKind::never : RefineKind::plain);
    const StateElementPair& elements = refinement.element_pairs[pair];
    refinement.order.push_back(
        {pair, elements.a, elements.b, std::pow(elements.radii + elements.contact_distance, 2)});
  }
  refinement.nearest_order = refinement.order;
  refinement.has_geometries = std::any_of(
      kinds.begin(), kinds.end(), [](RefineKind kind) { return kind != RefineKind::never; });
  refinement.memory = RefineStore(std::move(kinds));
  refinement.scratch = std::make_unique<RefineScratch>();
  refinement.near.reserve(setup.table.size());
  refinement.place_of.resize(setup.element_pairs.size(), kNone);
  refinement.pairs.reserve(setup.element_pairs.size());
  refinement.touched.resize(setup.element_pairs.size(), 0);
  refinement.searched_in.resize(setup.element_pairs.size(), 0);
  return refinement;
}

void refineContacts(const CycleSetup& setup, const OpenStates& open, StatesWork& work,
                    BlockChecks& checks) noexcept {
  StateNumber asked;
  for (std::size_t lane = 0; lane < kStateCount; ++lane) {
    asked.of[lane] = open[lane] ? kContactsAsked : kNotAsked;
    if (open[lane]) {
      checks[lane] = StateCheck();
      checks[lane].verdict = Verdict::clear;
    }
  }
  // Mostly one of the pairs last in contact is in contact again.
  const std::size_t all = work.refinement.order.size();
  const std::size_t few = std::min<std::size_t>(6, all);
  for (std::size_t lane = 0; lane < kStateCount;) {
    findContacts(setup, {asked, 0, few, false, true}, lane, asked, work, checks);
    lane += findContacts(setup, {asked, few, all, false, true}, lane, asked, work, checks);
  }
}

void refineNearest(const CycleSetup& setup, const OpenStates& open, StatesWork& work,
                   BlockChecks& checks) noexcept {
  // Geometries are mostly not much farther apart than the shapes that enclose them. If they are,
  // their distance limits the next query. Limits of their own may make a farther pair a warning.
  constexpr double kOvershoots = 0.02;  // [m] of two shapes
  const double farthest =
      largestOfLimits(setup, [](const Limits& limits) { return limits.warning_distance; });
  StateNumber asked;
  BlockChecks known;
  for (std::size_t lane = 0; lane < kStateCount; ++lane) {
    asked.of[lane] = kNotAsked;
    if (open[lane]) {
      ++work.refinement.state;
      known[lane] = measureConvex({setup, work, lane}, checks[lane]);
      const double near = std::max(checks[lane].distance, 0.0) + kOvershoots;
      const double nearest = known[lane].has_pair ? known[lane].distance : near;
      asked.of[lane] = setup.own_limits.empty() ? std::min({near, nearest, farthest}) : farthest;
    }
  }
  constexpr int kMostQueries = 40;  // more than it takes to reach the farthest pair
  const auto isAsked = [](double distance) { return distance != kNotAsked; };
  for (int i = 0; i < kMostQueries && std::any_of(asked.of, asked.of + kStateCount, isAsked); ++i) {
    findNearestOf(setup, asked, known, work, checks);
  }
}

void settleContacts(const CycleSetup& setup, StatesWork& work, OpenStates& open,
                    BlockChecks& checks) noexcept {
  refineContacts(setup, open, work, checks);
  StateNumber touching;
  for (std::size_t lane = 0; lane < kStateCount; ++lane) {
    const bool is_contact = open[lane] && checks[lane].verdict == Verdict::contact;
    touching.of[lane] = !is_contact                ? kNotAsked
                        : setup.own_limits.empty() ? kContactsAsked
                                                   : checks[lane].distance;
    open[lane] = open[lane] && !is_contact;
  }
  // Depths of concave geometries are not needed.
  const bool is_convex_only =
      largestOfLimits(setup, [](const Limits& limits) { return limits.contact_distance; }) <= 0.0;
  visitAll(
      setup, {touching, 0, work.refinement.order.size(), is_convex_only}, work,
      [&](const StateSearch& state, bool) noexcept { findNearest(state, checks[state.lane]); });
}

}  // namespace collision_monitor
