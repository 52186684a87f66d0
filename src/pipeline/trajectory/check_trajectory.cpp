// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/trajectory/check_trajectory.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "geometry/constants.h"
#include "pipeline/trajectory/trajectory_search.h"

namespace collision_monitor {
namespace {

/// The shortest part is 1e-15 of a segment.
constexpr std::size_t kMostHalvings = 50;
/// [m] Between two way-points a distance is rarely less than at both by more than this.
constexpr double kBeyondMargin = 0.1;
/// How many segments are first settled as one part, which is enough for far pairs.
constexpr std::size_t kSegmentsAtOnce = 8;
/// Progress is reported after 1/16 of a segment, and after longer parts.
constexpr std::size_t kToldHalvings = 4;

Halving& halvingAt(const TrajectorySearch& search, std::size_t depth,
                   std::deque<Halving>& halvings) {
  while (halvings.size() <= depth) {
    halvings.emplace_back();
    halvings.back().travels.resize(search.path.joints.size());
    halvings.back().steps.resize(search.path.joints.size());
  }
  return halvings[depth];
}

/// Marks clear pairs as undecided: the search has ended.
void giveUpAll(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
               const Instant& at) {
  for (const LinkPairIndex pair : pairs) {
    if (search.report.pairs[pair].state == ApproachState::clear) {
      giveUp(search, pair, at);
    }
  }
}

/// Settles pairs between two instants of one segment, the earlier half first.
void explore(TrajectorySearch& search, Instant& begin, Instant& end,
             const std::vector<LinkPairIndex>& pairs, std::size_t depth) {
  Halving& halving = halvingAt(search, depth, search.halvings);
  for (std::size_t i = 0; i < halving.travels.size(); ++i) {
    halving.travels[i] = travelOf(search.path, {begin.segment, begin.share, end.share}, i);
  }
  search.measures.work += pairs.size();
  halving.open.clear();
  halving.pairs = &pairs;
  halving.is_placed = false;
  halving.depth = depth;
  search.levers.moveTo(begin.world_from_link);
  for (const LinkPairIndex pair : pairs) {
    if (!goesOnWorking(search, begin) || !settle(search, pair, begin, end, halving)) {
      halving.open.push_back(pair);
    }
  }
  if (halving.open.empty()) {
    return;
  }
  if (search.is_ended || search.measures.work >= search.options.budget || depth == kMostHalvings) {
    giveUpAll(search, halving.open, begin);
    return;
  }
  Instant& middle = halving.middle;
  placeMiddle(search, begin, end, halving);
  noteBalls(search, halving.open, middle);
  sampleBalls(search, halving.open, middle);
  explore(search, begin, middle, halving.open, depth + 1);
  if (depth < kToldHalvings) {
    goesOn(search, middle.segment, middle.share);
  }
  explore(search, middle, end, halving.open, depth + 1);
}

/// Settles pairs that the path does not move; all pairs if there is only one way-point.
void checkStanding(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs, Instant& at) {
  Halving halving;
  halving.travels.resize(search.path.joints.size(), 0.0);
  search.levers.moveTo(at.world_from_link);
  for (const LinkPairIndex pair : pairs) {
    if (goesOnWorking(search, at)) {
      settle(search, pair, at, at, halving);
    } else if (search.report.pairs[pair].state == ApproachState::clear) {
      giveUp(search, pair, at);
    }
  }
}

/// Lists pairs that the samples at two stops do not settle; fills the travel between these.
void listOpen(TrajectorySearch& search, std::size_t first, std::size_t last,
              const std::vector<LinkPairIndex>& pairs, Halving& range) {
  std::fill(range.travels.begin(), range.travels.end(), 0.0);
  for (std::size_t stop = first; stop < last; ++stop) {
    for (std::size_t i = 0; i < range.travels.size(); ++i) {
      range.travels[i] += travelOf(search.path, {search.first_stop + stop, 0.0, 1.0}, i);
    }
  }
  search.measures.work += pairs.size();
  range.open.clear();
  search.levers.moveTo(search.stops[first].world_from_link);
  for (const LinkPairIndex pair : pairs) {
    if (!settleFar(search, pair, search.stops[first], search.stops[last], range.travels)) {
      range.open.push_back(pair);
    }
  }
}

/// Settles pairs between two stops.
void exploreStops(TrajectorySearch& search, std::size_t first, std::size_t last,
                  const std::vector<LinkPairIndex>& pairs, std::size_t depth) {
  Instant& begin = search.stops[first];
  Instant& end = search.stops[last];
  if (last - first == 1) {
    begin.segment = end.segment = search.first_stop + first;
    begin.share = 0.0;
    end.share = 1.0;
    explore(search, begin, end, pairs, 0);
    return;
  }
  Halving& range = halvingAt(search, depth, search.ranges);
  listOpen(search, first, last, pairs, range);
  const std::size_t middle = first + (last - first) / 2;
  Instant& at_middle = search.stops[middle];
  settleClose(search, first, middle, last, range);
  sampleWaypoint(search, range.open, search.first_stop + middle, at_middle);
  exploreStops(search, first, middle, range.open, depth + 1);
  if (!goesOn(search, at_middle.segment, at_middle.share)) {
    giveUpAll(search, search.moving, at_middle);
    return;
  }
  exploreStops(search, middle, last, range.open, depth + 1);
}

/// Places links at the next stops. @return how many segments these bound.
/// @param measured end of the way-points with measured bodies; stops do not pass it, except one
std::size_t placeStops(TrajectorySearch& search, std::size_t measured) {
  const std::size_t first = search.first_stop;
  const std::size_t last = std::min(first + kSegmentsAtOnce, measured - 1);
  const std::size_t count = std::max<std::size_t>(1, last - first);
  for (std::size_t i = 1; i <= count; ++i) {
    Instant& stop = search.stops[i];
    stop.segment = first + i - 1;
    stop.share = 1.0;
    place(search, stop);
    noteBalls(search, search.moving, stop);
  }
  return count;
}

void followPath(TrajectorySearch& search) {
  std::vector<LinkPairIndex>& moving = search.moving;
  const std::size_t segments = search.path.times.size() - 1;
  std::size_t measured = lookAhead(search, moving, 0);
  sampleWaypoint(search, moving, 0, search.stops[0]);
  noteBalls(search, moving, search.stops[0]);
  while (search.first_stop < segments) {
    const std::size_t count = placeStops(search, measured);
    measured = lookAhead(search, moving, search.first_stop + count);
    Instant& end = search.stops[count];
    sampleWaypoint(search, moving, search.first_stop + count, end);
    exploreStops(search, 0, count, moving, 0);
    if (!goesOn(search, end.segment, 1.0)) {
      giveUpAll(search, moving, end);
      return;
    }
    std::swap(search.stops[0], end);
    search.first_stop += count;
    const auto is_done = [&](LinkPairIndex pair) {
      return search.report.pairs[pair].state != ApproachState::clear;
    };
    moving.erase(std::remove_if(moving.begin(), moving.end(), is_done), moving.end());
  }
}

/// A pair to measure where its bodies at way-points, or else its balls, are nearest.
struct FarPair {
  NearPlace at;
  LinkPairIndex pair;
};

/// Lists clear pairs that are not measured there yet, in order of time.
std::vector<FarPair> listFarPairs(const TrajectorySearch& search) {
  std::vector<FarPair> far;
  for (LinkPairIndex pair = 0; pair < search.chains.size(); ++pair) {
    const PairApproach& approach = search.report.pairs[pair];
    const double found = approach.nearest.measured.distance;
    const bool is_by_waypoint = search.by_waypoints[pair].bound < found;
    const bool is_asked =
        search.found[pair] == Found::bodies
            ? is_by_waypoint || found == kInfinity
            : search.found[pair] == Found::bounds && marginOf(search.options, pair) > 0.0;
    if (approach.state == ApproachState::clear && is_asked) {
      far.push_back({is_by_waypoint ? search.by_waypoints[pair] : search.by_balls[pair], pair});
    }
  }
  std::sort(far.begin(), far.end(), [](const FarPair& one, const FarPair& other) {
    return std::tie(one.at.segment, one.at.share, one.pair) <
           std::tie(other.at.segment, other.at.share, other.pair);
  });
  return far;
}

void measureFarPairs(TrajectorySearch& search) {
  Instant at;
  for (const FarPair& far : listFarPairs(search)) {
    if (!goesOnAtEnd(search)) {
      giveUp(search, far.pair, search.stops[0]);
      continue;
    }
    if (at.world_from_link.empty() || at.segment != far.at.segment || at.share != far.at.share) {
      at.segment = far.at.segment;
      at.share = far.at.share;
      place(search, at);
    }
    const bool is_of_bodies = search.found[far.pair] == Found::bodies;
    const PairDistance distance =
        is_of_bodies ? bodyDistance(search.measures, far.pair, at.world_from_link)
                     : elementDistance(search.measures, far.pair, at.world_from_link);
    keepNearest(search, far.pair, distance, at, is_of_bodies ? Found::bodies : Found::elements);
  }
}

bool isKnown(const LinkPoses& start, const CheckedLinkPair& links) noexcept {
  return isJoined(start, links.a, links.b) && isRigid(start.world_from_link[index(links.a)]) &&
         isRigid(start.world_from_link[index(links.b)]);
}

TrajectorySearch searchAlong(const CycleSetup& setup, const JointPath& path, const LinkPoses& start,
                             const TrajectoryOptions& options) {
  const std::size_t count = setup.checked.size();
  LinkPairMeasures measures(setup);
  JointLevers levers(measures.balls, setup.model, path);
  TrajectorySearch search{setup,
                          path,
                          options,
                          PathPoses(setup.model, path, start),
                          std::move(measures),
                          std::move(levers),
                          std::vector<LinkChain>(count),
                          std::vector<Found>(count, Found::bodies),
                          std::vector<NearPlace>(count),
                          std::vector<NearPlace>(count),
                          std::vector<Level>(count, Level::balls),
                          {},
                          {},
                          {},
                          std::vector<Instant>(kSegmentsAtOnce + 1),
                          0,
                          {},
                          false,
                          {},
                          {},
                          0};
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
  std::vector<LinkPairIndex>& moving = search.moving;
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
  Instant& begin = search.stops[0];
  place(search, begin);
  sampleBalls(search, standing, begin);
  noteBalls(search, standing, begin);
  checkStanding(search, standing, begin);
  followPath(search);
  measureFarPairs(search);
  search.report.work = search.measures.work;
  return std::move(search.report);
}

}  // namespace collision_monitor
