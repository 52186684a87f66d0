// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/robot_query.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/pipeline/pair_blocks.h"
#include "library/query_parts.h"
#include "narrow_phase/distance.h"
#include "pipeline/answers/contact_manifold.h"

namespace collision_monitor {
namespace {

void place(Numbers state, QueryParts& parts) {
  checkStateSize(parts.monitor, state);
  readPositions(state, parts.state);
  placeLinks(parts.setup.model, parts.state, parts.shared.world_from_root,
             parts.poses.world_from_link);
}

void placeShapes(Numbers state, QueryParts& parts) {
  place(state, parts);
  placeAll(parts.setup, parts.poses, parts.links);
}

/// Lists of each pair of elements its nearest bodies, if these are within a distance.
void listNear(double within, QueryParts& parts) {
  const auto& near = parts.near_bodies;
  findNear(parts.setup.blocks, parts.links.body_poses.rows, within, parts.near_bodies);
  for (const NearestPair& bodies : near) {
    parts.nearest_of[parts.setup.element_pair_of[index(bodies.pair)]] = kNone;
  }
  for (std::uint32_t i = 0; i < near.size(); ++i) {
    std::uint32_t& nearest = parts.nearest_of[parts.setup.element_pair_of[index(near[i].pair)]];
    if (nearest == kNone || near[i].distance < near[nearest].distance) {
      nearest = i;
    }
  }
  std::vector<PairId>& candidates = parts.links.candidates;
  candidates.clear();
  for (std::uint32_t i = 0; i < near.size(); ++i) {
    if (parts.nearest_of[parts.setup.element_pair_of[index(near[i].pair)]] == i) {
      candidates.push_back(near[i].pair);
    }
  }
}

/// Measures each pair of elements whose nearest bodies are within a distance, and all whose bodies
/// overlap: depths of bodies without points are no bounds. Others are farther apart than that.
void measureNear(double distance, Asked asked, QueryParts& parts) {
  const double within = std::max(distance, 0.0);
  listNear(within, parts);
  measureWithin(parts.setup, within, asked, parts.links);
  std::fill(parts.verdicts.begin(), parts.verdicts.end(), Verdict::clear);
  for (const PairDistance& measured : parts.links.distances.pairs) {
    Verdict& verdict = parts.verdicts[parts.setup.link_pair_of[index(measured.pair)]];
    verdict = std::max(verdict, verdictOf(parts.setup, measured));
  }
}

bool isUnknown(const QueryParts& parts, LinkPairIndex pair) {
  const CheckedLinkPair& links = parts.setup.checked[pair];
  return !isJoined(parts.links.body_poses, links.a, links.b);
}

MeasuredPair answerOf(const QueryParts& parts, LinkPairIndex pair) {
  return isUnknown(parts, pair)
             ? unknownPair(pair)
             : measuredPair(parts.setup, parts.links.of(pair), parts.verdicts[pair]);
}

/// Calls `take` with the index of each pair that is unknown or within a distance, in order.
template <class Take>
void forPairsWithin(double within, const QueryParts& parts, const Take& take) {
  for (LinkPairIndex i = 0; i < parts.setup.checked.size(); ++i) {
    if (isUnknown(parts, i) ||
        (parts.links.nearest[i] != kNone && parts.links.of(i).measured.distance <= within)) {
      take(i);
    }
  }
}

void addGradient(LinkPairIndex pair, QueryParts& parts) {
  const std::size_t n = parts.setup.model.variable_count;
  std::vector<double>& gradients = parts.table.gradients;
  const std::size_t first = gradients.size();
  if (isUnknown(parts, pair)) {
    gradients.resize(first + n, kUnknown);
    return;
  }
  gradients.resize(first + n, 0.0);
  for (const GradientEntry& entry : parts.rows.of(parts.links.of(pair))) {
    gradients[first + entry.variable] = entry.value;
  }
}

TouchingPair touchingPair(const QueryParts& parts, LinkPairIndex pair) {
  TouchingPair contact;
  contact.between = answerOf(parts, pair);
  contact.points.fill(Eigen::Vector3d::Constant(kUnknown));
  if (isUnknown(parts, pair)) {
    return contact;
  }
  const PairDistance& distance = parts.links.of(pair);
  const SignedDistance& measured = distance.measured;
  contact.point_count = 1;
  contact.points[0] = 0.5 * (measured.point_on_a + measured.point_on_b);
  if (const auto manifold = contactManifold(parts.setup, parts.links.body_poses, distance)) {
    contact.point_count = static_cast<std::uint32_t>(manifold->size);
    for (std::size_t i = 0; i < manifold->size; ++i) {
      contact.points[i] = 0.5 * (manifold->points[i].point_on_a + manifold->points[i].point_on_b);
    }
  }
  return contact;
}

constexpr auto kAnyPair = [](LinkPairIndex) { return true; };

/// Measures the elements of one pair of bodies; beyond `within` [m] only a bound.
/// @return kNone if their distance is unknown
LinkPairIndex measureOne(PairId pair, double within, QueryParts& parts) {
  const BodyPair& bodies = parts.setup.table[pair];
  const auto linkOf = [&](BodyId body) { return parts.setup.bodies[index(body)].link; };
  if (!isJoined(parts.links.body_poses, linkOf(bodies.a), linkOf(bodies.b))) {
    return kNone;
  }
  parts.links.candidates.assign(1, pair);
  measureWithin(parts.setup, std::max(within, 0.0), Asked::within, parts.links);
  const LinkPairIndex links = parts.setup.link_pair_of[index(pair)];
  return parts.links.nearest[links] != kNone ? links : LinkPairIndex{kNone};
}

/// A pair that is near, and the distance of its elements.
struct Likely {
  PairId pair{};
  double distance{std::numeric_limits<double>::infinity()};  ///< [m]; infinite: there is none
};

void improve(PairId pair, QueryParts& parts, Likely& likely) {
  const LinkPairIndex links = measureOne(pair, likely.distance, parts);
  if (links != kNone && parts.links.of(links).measured.distance < likely.distance) {
    likely = {pair, parts.links.of(links).measured.distance};
  }
}

/// [m] NaN if a body is not known.
double bodyDistance(PairId pair, const QueryParts& parts) {
  const CycleSetup& setup = parts.setup;
  const std::vector<Pose>& poses = parts.links.body_poses.world_from_body;
  const std::size_t a = index(setup.table[pair].a);
  const std::size_t b = index(setup.table[pair].b);
  return distanceBetween(setup.bodies[a].shape, poses[a], setup.bodies[b].shape, poses[b]).distance;
}

/// Takes the pair that was nearest in the last state, unless the joints have jumped so that it is
/// far now: then the pair of the nearest bodies.
Likely findLikely(QueryParts& parts) {
  constexpr double kJump = 0.01;  // [m]
  const double most = parts.last_distance + kJump;
  Likely likely;
  if (parts.last_nearest && bodyDistance(*parts.last_nearest, parts) <= most) {
    improve(*parts.last_nearest, parts, likely);
  }
  if (likely.distance > most) {
    NearestPair bodies{likely.pair, likely.distance};
    searchBlocks(parts.setup.blocks, parts.links.body_poses.rows,
                 {parts.setup.element_pair_of, parts.none_passed}, bodies);
    if (bodies.distance < likely.distance) {
      improve(bodies.pair, parts, likely);
    }
  }
  return likely;
}

/// The nearest of all pairs; kNone if none is known. A first pair limits the search for others.
LinkPairIndex measureNearest(QueryParts& parts) {
  constexpr double kRounding = 1e-9;  // bodies are measured by two routines
  const Likely likely = findLikely(parts);
  if (!(likely.distance < std::numeric_limits<double>::infinity())) {
    return kNone;
  }
  measureNear(likely.distance + kRounding, Asked::nearest, parts);
  const LinkPairIndex closest = closestOf(parts.links, kAnyPair);
  if (closest == kNone) {
    return measureOne(likely.pair, likely.distance, parts);  // very far away, rounding is larger
  }
  parts.last_nearest = parts.links.of(closest).pair;
  parts.last_distance = parts.links.of(closest).measured.distance;
  return closest;
}

}  // namespace

RobotQuery::RobotQuery(const RobotMonitor& monitor)
    : parts_(std::make_unique<QueryParts>(monitor)) {}
RobotQuery::~RobotQuery() = default;
RobotQuery::RobotQuery(RobotQuery&& other) noexcept = default;
RobotQuery& RobotQuery::operator=(RobotQuery&& other) noexcept = default;

const RobotMonitor& RobotQuery::monitor() const noexcept { return parts_->monitor; }

const DistanceTable& RobotQuery::distances(Numbers state, const DistanceRequest& request) {
  if (std::isnan(request.within)) {
    throw ArgumentError({"`within` is not a number; give metres, or infinity for all pairs"});
  }
  QueryParts& parts = *parts_;
  placeShapes(state, parts);
  measureNear(request.within, Asked::within, parts);
  parts.table.pairs.clear();
  parts.table.gradients.clear();
  if (request.gradients) {
    parts.rows.moveTo(parts.poses);
    parts.table.gradients.reserve(parts.setup.checked.size() * parts.setup.model.variable_count);
  }
  forPairsWithin(request.within, parts, [&](LinkPairIndex pair) {
    parts.table.pairs.push_back(answerOf(parts, pair));
    if (request.gradients) {
      addGradient(pair, parts);
    }
  });
  return parts.table;
}

const MeasuredPair& RobotQuery::nearest(Numbers state) {
  QueryParts& parts = *parts_;
  placeShapes(state, parts);
  const LinkPairIndex closest = measureNearest(parts);
  const bool has_pairs = !parts.setup.checked.empty();
  parts.nearest = closest != kNone ? answerOf(parts, closest) : unknownPair(has_pairs ? 0 : kNone);
  return parts.nearest;
}

const std::vector<TouchingPair>& RobotQuery::contacts(Numbers state) {
  QueryParts& parts = *parts_;
  placeShapes(state, parts);
  const double within = std::max(0.0, largestOfLimits(parts.setup, [](const Limits& limits) {
                                   return limits.contact_distance;
                                 }));
  measureNear(within, Asked::within, parts);
  parts.contacts.clear();
  forPairsWithin(within, parts, [&](LinkPairIndex pair) {
    if (isUnknown(parts, pair) || parts.verdicts[pair] == Verdict::contact) {
      parts.contacts.push_back(touchingPair(parts, pair));
    }
  });
  return parts.contacts;
}

const std::vector<Pose>& RobotQuery::linkPoses(Numbers state) {
  place(state, *parts_);
  return parts_->poses.world_from_link;
}

}  // namespace collision_monitor
