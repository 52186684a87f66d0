// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/robot_query.h"

#include <algorithm>
#include <cmath>

#include "collision_monitor/pipeline/pair_blocks.h"
#include "library/query_parts.h"
#include "pipeline/answers/contact_manifold.h"

namespace collision_monitor {
namespace {

void place(Numbers state, QueryParts& parts) {
  checkStateSize(parts.monitor, state);
  readPositions(state, parts.state);
  placeLinks(parts.setup.model, parts.state, parts.shared.world_from_root,
             parts.poses.world_from_link);
}

/// Measures the bodies of all pairs, without points, and finds the nearest of each pair of
/// elements.
void measureBodies(QueryParts& parts) {
  const CycleSetup& setup = parts.setup;
  placeAll(setup, parts.poses, parts.links);
  measureBlocks(setup.blocks, parts.links.body_poses.rows, parts.of_bodies);
  std::fill(parts.nearest_bodies.begin(), parts.nearest_bodies.end(), kNone);
  for (std::uint32_t id = 0; id < parts.of_bodies.size(); ++id) {
    std::uint32_t& nearest = parts.nearest_bodies[setup.element_pair_of[id]];
    const double distance = parts.of_bodies[id];
    if (!std::isnan(distance) && (nearest == kNone || distance < parts.of_bodies[nearest])) {
      nearest = id;
    }
  }
}

/// Measures each pair of elements whose nearest bodies are within a distance, and all whose bodies
/// overlap: depths of bodies without points are no bounds. Others are farther apart than that.
void measureNear(double distance, QueryParts& parts) {
  const double within = std::max(distance, 0.0);
  std::vector<PairId>& candidates = parts.links.candidates;
  candidates.clear();
  for (const std::uint32_t id : parts.nearest_bodies) {
    if (id != kNone && parts.of_bodies[id] <= within) {
      candidates.push_back(idAt<PairId>(id));
    }
  }
  std::sort(candidates.begin(), candidates.end());
  measureWithin(parts.setup, within, parts.links);
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

/// The distance of the nearest bodies of all; infinity if there are none.
double leastOfBodies(const QueryParts& parts) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t id : parts.nearest_bodies) {
    least = id == kNone ? least : std::min(least, parts.of_bodies[id]);
  }
  return least;
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
  place(state, parts);
  measureBodies(parts);
  measureNear(request.within, parts);
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
  place(state, parts);
  measureBodies(parts);
  // What the nearest bodies enclose is mostly the nearest. If not, what is nearer is within that.
  const auto any = [](LinkPairIndex) { return true; };
  measureNear(leastOfBodies(parts), parts);
  LinkPairIndex closest = closestOf(parts.links, any);
  if (closest != kNone) {
    constexpr double kRounding = 1e-9;  // bodies are measured by two routines
    measureNear(parts.links.of(closest).measured.distance + kRounding, parts);
    closest = closestOf(parts.links, any);
  }
  const bool has_pairs = !parts.setup.checked.empty();
  parts.nearest = closest != kNone ? answerOf(parts, closest) : unknownPair(has_pairs ? 0 : kNone);
  return parts.nearest;
}

const std::vector<TouchingPair>& RobotQuery::contacts(Numbers state) {
  QueryParts& parts = *parts_;
  place(state, parts);
  measureBodies(parts);
  const double within = std::max(0.0, largestOfLimits(parts.setup, [](const Limits& limits) {
                                   return limits.contact_distance;
                                 }));
  measureNear(within, parts);
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
