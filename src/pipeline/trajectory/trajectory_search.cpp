// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/trajectory/trajectory_search.h"

#include <algorithm>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

/// Progress is reported after so much work.
constexpr std::uint64_t kToldWork = 2000;

void keepNearer(double bound, const Instant& at, NearPlace& nearest) noexcept {
  if (bound < nearest.bound) {
    nearest = {bound, at.segment, at.share};
  }
}

double ballsApart(const TrajectorySearch& search, LinkPairIndex pair, const Instant& at) noexcept {
  const CheckedLinkPair& links = search.setup.checked[pair];
  const std::vector<Ball>& balls = search.measures.balls;
  return (at.centers[index(links.a)] - at.centers[index(links.b)]).norm() -
         balls[index(links.a)].radius - balls[index(links.b)].radius;
}

/// A bound at a cutoff has no points that show it: gives it those of the enclosing shapes.
PairDistance withPoints(TrajectorySearch& search, LinkPairIndex pair, const PairDistance& distance,
                        const Instant& at) noexcept {
  const SignedDistance& found = distance.measured;
  const Eigen::Vector3d shown_gap = found.point_on_b - found.point_on_a;
  constexpr double kRounding = 1e-9;
  if ((shown_gap - found.distance * found.normal_a_to_b).norm() <= kRounding) {
    return distance;
  }
  PairDistance shown = bodyDistance(search.measures, pair, at.world_from_link);
  shown.measured.distance = found.distance;
  shown.quality = distance.quality;
  return shown;
}

/// Measures the elements of a pair if they may be nearer than its nearest measurement.
void lookForNearer(TrajectorySearch& search, LinkPairIndex pair, double bound, Instant& at) {
  const double wanted = wantedOf(search, pair);
  if (!(wanted > 0.0) || bound > wanted) {
    return;
  }
  place(search, {pair}, at);
  const PairDistance found = elementDistance(search.measures, pair, at.world_from_link, wanted);
  if (found.measured.distance < wanted) {
    keepNearest(search, pair, found, at, Found::elements);
  }
}

}  // namespace

double wantedOf(const TrajectorySearch& search, LinkPairIndex pair) noexcept {
  const double nearest = search.found[pair] == Found::elements
                             ? search.report.pairs[pair].nearest.measured.distance
                             : kInfinity;
  return std::min(marginOf(search.options, pair), nearest - search.options.resolution);
}

Sample sampleBy(const TrajectorySearch& search, LinkPairIndex pair, double distance,
                Level level) noexcept {
  const double contact = limitsOf(search.setup, pair).contact_distance;
  const double bound = distance > 0.0 || contact >= 0.0 ? distance : -kInfinity;
  return {bound, bound - std::max(0.0, contact), level, false, kInfinity};
}

double timeOf(const TrajectorySearch& search, const Instant& at) noexcept {
  return timeAt(search.path, at.segment, at.share);
}

void keepNearest(TrajectorySearch& search, LinkPairIndex pair, const PairDistance& distance,
                 const Instant& at, Found found) noexcept {
  PairApproach& approach = search.report.pairs[pair];
  Found& last = search.found[pair];
  const bool is_nearer = distance.measured.distance < approach.nearest.measured.distance;
  if (found != last ? found > last : is_nearer) {
    approach.nearest = withPoints(search, pair, distance, at);
    approach.nearest.is_raised = found == Found::bounds;
    approach.time = timeOf(search, at);
    last = found;
  }
}

void place(TrajectorySearch& search, Instant& at) {
  search.poses.place(at.segment, at.share, at.world_from_link);
  at.centers.resize(at.world_from_link.size());
  for (std::size_t i = 0; i < at.centers.size(); ++i) {
    at.centers[i] = at.world_from_link[i] * search.measures.balls[i].center;
  }
}

void place(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs, Instant& at) {
  search.is_wanted.assign(search.setup.model.links.size(), 0);
  for (const LinkPairIndex pair : pairs) {
    search.poses.mark(search.setup.checked[pair].a, search.setup.checked[pair].b, search.is_wanted);
  }
  search.measures.work +=
      search.poses.place(at.segment, at.share, search.is_wanted, at.world_from_link);
  at.centers.resize(at.world_from_link.size());
  for (std::size_t i = 0; i < at.centers.size(); ++i) {
    if (search.is_wanted[i] != 0) {
      at.centers[i] = at.world_from_link[i] * search.measures.balls[i].center;
    }
  }
}

void noteBalls(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
               const Instant& at) noexcept {
  for (const LinkPairIndex pair : pairs) {
    keepNearer(ballsApart(search, pair, at), at, search.by_balls[pair]);
  }
}

void sampleBalls(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                 Instant& at) noexcept {
  at.samples.resize(search.chains.size());
  for (const LinkPairIndex pair : pairs) {
    at.samples[pair] = sampleBy(search, pair, ballsApart(search, pair, at), Level::balls);
  }
}

std::size_t lookAhead(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                      std::size_t waypoint) {
  const std::size_t count = search.path.times.size();
  if (!search.waypoints) {
    return count;
  }
  WaypointDistances& distances = *search.waypoints;
  const std::uint64_t work = measureWaypoint(search.setup, pairs, waypoint, distances);
  search.measures.work += work;
  Instant at;
  for (const LinkPairIndex pair : work > 0 ? pairs : std::vector<LinkPairIndex>()) {
    if (!goesOnWorking(search, search.stops[0])) {
      break;
    }
    NearPlace nearest;
    for (std::size_t i = waypoint; i < distances.last; ++i) {
      at.segment = i > 0 ? i - 1 : 0;
      at.share = i > 0 ? 1.0 : 0.0;
      keepNearer(distanceAt(distances, i, pair), at, nearest);
    }
    if (nearest.bound < distances.reach) {
      at.segment = nearest.segment;
      at.share = nearest.share;
      keepNearer(nearest.bound, at, search.by_waypoints[pair]);
      lookForNearer(search, pair, nearest.bound, at);
    }
  }
  return distances.last;
}

void sampleWaypoint(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                    std::size_t waypoint, Instant& at) noexcept {
  sampleBalls(search, pairs, at);
  if (!search.waypoints) {
    return;
  }
  for (const LinkPairIndex pair : pairs) {
    const double bound = distanceAt(*search.waypoints, waypoint, pair);
    if (bound < search.waypoints->reach) {
      at.samples[pair] = sampleBy(search, pair, bound, Level::bodies);
    } else if (bound > at.samples[pair].bound) {
      at.samples[pair] = sampleBy(search, pair, bound, at.samples[pair].level);
    }
  }
}

bool goesOn(TrajectorySearch& search, std::size_t segment, double share) {
  const std::size_t segments = std::max<std::size_t>(2, search.path.times.size()) - 1;
  const double done = (static_cast<double>(segment) + share) / static_cast<double>(segments);
  search.told_work = search.measures.work;
  if (search.options.progress && !search.is_ended) {
    search.is_ended = !search.options.progress(done) && done < 1.0;
  }
  return !search.is_ended;
}

bool goesOnWorking(TrajectorySearch& search, const Instant& at) {
  return search.measures.work - search.told_work < kToldWork ? !search.is_ended
                                                             : goesOn(search, at.segment, at.share);
}

bool goesOnAtEnd(TrajectorySearch& search) {
  if (search.options.progress && search.measures.work - search.told_work >= kToldWork &&
      !search.is_ended) {
    search.told_work = search.measures.work;
    search.is_ended = !search.options.progress(1.0);
  }
  return !search.is_ended;
}

void giveUp(TrajectorySearch& search, LinkPairIndex pair, const Instant& at) noexcept {
  PairApproach& approach = search.report.pairs[pair];
  approach.state = ApproachState::undecided;
  approach.time = timeOf(search, at);
  approach.at_least = -kInfinity;
}

}  // namespace collision_monitor
