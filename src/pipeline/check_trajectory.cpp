// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/check_trajectory.h"

#include <utility>

#include "geometry/constants.h"
#include "pipeline/trajectory_search.h"

namespace collision_monitor {
namespace {

/// Halves of halves ...: parts of 1e-15 of the way from one point to the next.
constexpr std::size_t kMostHalvings = 50;
/// [m] Two links are mostly no nearer between two way-points than by this less than at both.
constexpr double kBeyondMargin = 0.1;
/// Progress is told after parts of 1/16 of the way from one point to the next, and longer ones.
constexpr std::size_t kToldHalvings = 4;

Halving& halvingAt(TrajectorySearch& search, std::size_t depth) {
  while (search.halvings.size() <= depth) {
    search.halvings.emplace_back();
    search.halvings.back().ways.resize(search.path.joints.size());
  }
  return search.halvings[depth];
}

/// Tells how much is done; false once the search is to end.
bool goesOn(TrajectorySearch& search, std::size_t segment, double share) {
  const auto segments = static_cast<double>(search.path.times.size() - 1);
  const double done = (static_cast<double>(segment) + share) / segments;
  if (search.options.progress && !search.is_ended) {
    search.is_ended = !search.options.progress(done) && done < 1.0;
  }
  return !search.is_ended;
}

/// Settles pairs in the part of the way between two instants of one segment, earlier halves first.
void explore(TrajectorySearch& search, Instant& begin, Instant& end,
             const std::vector<LinkPairIndex>& pairs, std::size_t depth) {
  Halving& halving = halvingAt(search, depth);
  for (std::size_t i = 0; i < halving.ways.size(); ++i) {
    halving.ways[i] = wayOf(search.path, {begin.segment, begin.share, end.share}, i);
  }
  search.measures.steps += pairs.size();
  halving.open.clear();
  for (const LinkPairIndex pair : pairs) {
    if (!settle(search, pair, begin, end, halving.ways)) {
      halving.open.push_back(pair);
    }
  }
  if (halving.open.empty()) {
    return;
  }
  if (search.is_ended || search.measures.steps >= search.options.budget || depth == kMostHalvings) {
    for (const LinkPairIndex pair : halving.open) {
      giveUp(search, pair, begin);
    }
    return;
  }
  Instant& middle = halving.middle;
  middle.segment = begin.segment;
  middle.share = 0.5 * (begin.share + end.share);
  search.poses.place(middle.segment, middle.share, middle.world_from_link);
  search.measures.steps += middle.world_from_link.size();
  sampleBalls(search, halving.open, middle);
  explore(search, begin, middle, halving.open, depth + 1);
  if (depth < kToldHalvings) {
    goesOn(search, middle.segment, middle.share);
  }
  explore(search, middle, end, halving.open, depth + 1);
}

/// Pairs that the path does not move, and all pairs where there is one way-point only.
void checkStanding(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs, Instant& at) {
  for (const LinkPairIndex pair : pairs) {
    settle(search, pair, at, at, std::vector<double>(search.path.joints.size(), 0.0));
  }
}

void followPath(TrajectorySearch& search, const std::vector<LinkPairIndex>& moving,
                Instant& begin) {
  Instant end;
  const std::size_t segments = search.path.times.size() - 1;
  for (std::size_t segment = 0; segment < segments; ++segment) {
    begin.segment = end.segment = segment;
    begin.share = 0.0;
    end.share = 1.0;
    search.poses.place(segment, 1.0, end.world_from_link);
    sampleWaypoint(search, moving, segment + 1, end);
    explore(search, begin, end, moving, 0);
    std::swap(begin, end);
    if (!goesOn(search, segment, 1.0)) {
      for (const LinkPairIndex pair : moving) {
        if (search.report.pairs[pair].state == ApproachState::clear) {
          giveUp(search, pair, begin);
        }
      }
      return;
    }
  }
}

/// Pairs that were far are measured where their bodies were nearest at a way-point, or their balls.
void measureFarPairs(TrajectorySearch& search) {
  Instant at;
  for (LinkPairIndex pair = 0; pair < search.chains.size(); ++pair) {
    PairApproach& approach = search.report.pairs[pair];
    const double found = approach.nearest.measured.distance;
    const bool is_far = approach.state == ApproachState::clear && search.is_final[pair] == 0;
    const bool is_by_waypoint = search.by_waypoints[pair].bound < found;
    if (is_far && (is_by_waypoint || found == kInfinity)) {
      const NearPlace& place = is_by_waypoint ? search.by_waypoints[pair] : search.by_balls[pair];
      at.segment = place.segment;
      at.share = place.share;
      search.poses.place(at.segment, at.share, at.world_from_link);
      keepNearest(search, pair, bodyDistance(search.measures, pair, at.world_from_link), at, false);
    }
  }
}

bool isKnown(const LinkPoses& start, const CheckedLinkPair& links) noexcept {
  return isJoined(start, links.a, links.b) && isRigid(start.world_from_link[index(links.a)]) &&
         isRigid(start.world_from_link[index(links.b)]);
}

TrajectorySearch searchAlong(const CycleSetup& setup, const JointPath& path, const LinkPoses& start,
                             const TrajectoryOptions& options) {
  const std::size_t count = setup.checked.size();
  TrajectorySearch search{setup,
                          path,
                          options,
                          PathPoses(setup.model, path, start),
                          LinkPairMeasures(setup),
                          std::vector<LinkChain>(count),
                          std::vector<unsigned char>(count, 0),
                          std::vector<NearPlace>(count),
                          std::vector<NearPlace>(count),
                          {},
                          {},
                          false,
                          {}};
  search.report.pairs.resize(count);
  return search;
}

}  // namespace

TrajectoryReport checkTrajectory(const CycleSetup& setup, const JointPath& path,
                                 const LinkPoses& start, const TrajectoryOptions& options) {
  TrajectorySearch search = searchAlong(setup, path, start, options);
  if (!isSound(path)) {
    return search.report;
  }
  std::vector<LinkPairIndex> standing;
  std::vector<LinkPairIndex> moving;
  for (LinkPairIndex pair = 0; pair < setup.checked.size(); ++pair) {
    const CheckedLinkPair& links = setup.checked[pair];
    if (!isKnown(start, links)) {
      continue;
    }
    PairApproach& approach = search.report.pairs[pair];
    approach.state = ApproachState::clear;
    approach.at_least = approach.nearest.measured.distance = kInfinity;
    search.chains[pair] = chainBetween(setup.model, path, links.a, links.b);
    const bool is_moving = path.times.size() > 1 && !search.chains[pair].joints.empty();
    (is_moving ? moving : standing).push_back(pair);
  }
  if (path.times.size() >= kStateCount && !moving.empty()) {
    search.waypoints = makeWaypointDistances(setup, path, start, options.margin + kBeyondMargin);
  }
  Instant begin;
  search.poses.place(0, 0.0, begin.world_from_link);
  sampleBalls(search, standing, begin);
  sampleWaypoint(search, moving, 0, begin);
  checkStanding(search, standing, begin);
  followPath(search, moving, begin);
  measureFarPairs(search);
  search.report.steps = search.measures.steps;
  return std::move(search.report);
}

}  // namespace collision_monitor
