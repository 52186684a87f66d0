// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/trajectory_search.h"

#include <algorithm>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

double contactAt(const TrajectorySearch& search, LinkPairIndex pair) noexcept {
  return search.setup.checked[pair].limits.contact_distance + search.options.tolerance;
}

/// [m] What a bound must exceed to settle a part of the way.
double neededFor(const TrajectorySearch& search, LinkPairIndex pair) noexcept {
  const double found =
      search.is_final[pair] != 0 ? search.report.pairs[pair].nearest.measured.distance : kInfinity;
  return std::max(contactAt(search, pair),
                  std::min(search.options.margin, found - search.options.resolution));
}

/// [m] What balls or bodies say of elements. Where some depth is allowed, those that overlap say
/// nothing: see contactOfBodies.
double boundBy(const TrajectorySearch& search, LinkPairIndex pair, double distance) noexcept {
  return distance > 0.0 || contactAt(search, pair) > 0.0 ? distance : -kInfinity;
}

double timeOf(const TrajectorySearch& search, const Instant& at) noexcept {
  return timeAt(search.path, at.segment, at.share);
}

/// The next level of a sample.
void raise(TrajectorySearch& search, LinkPairIndex pair, Instant& at) noexcept {
  Sample& sample = at.samples[pair];
  const bool is_final = sample.level == Level::bodies;
  const PairDistance distance = is_final
                                    ? elementDistance(search.measures, pair, at.world_from_link)
                                    : bodyDistance(search.measures, pair, at.world_from_link);
  // An estimate of a depth is a contact, however deep that may be allowed to be.
  const bool is_overlap = distance.quality == Quality::estimate;
  const double bound =
      is_final ? distance.measured.distance : boundBy(search, pair, distance.measured.distance);
  sample.bound = is_overlap ? -kInfinity : std::max(sample.bound, bound);
  sample.level = is_final ? Level::elements : Level::bodies;
  keepNearest(search, pair, distance, at, is_final);
}

bool isContact(const TrajectorySearch& search, LinkPairIndex pair, const Instant& at) noexcept {
  const Sample& sample = at.samples[pair];
  return sample.level == Level::elements && sample.bound <= contactAt(search, pair);
}

void keepContact(TrajectorySearch& search, LinkPairIndex pair, const Instant& at) {
  PairApproach& approach = search.report.pairs[pair];
  approach.state = ApproachState::contact;
  approach.nearest = elementDistance(search.measures, pair, at.world_from_link);
  approach.time = timeOf(search, at);
  approach.at_least = std::min(approach.at_least, approach.nearest.measured.distance);
  const LinkPairIndex first = search.report.first_contact;
  if (first == kNone || approach.time < search.report.pairs[first].time) {
    search.report.first_contact = pair;
    search.report.world_from_link = at.world_from_link;
  }
}

/// Raises what helps to settle a part, the cheaper first; false if nothing does.
bool raiseOne(TrajectorySearch& search, LinkPairIndex pair, Instant& begin, Instant& end) noexcept {
  for (Instant* at : {&begin, &end}) {
    if (at->samples[pair].level == Level::balls) {
      raise(search, pair, *at);
      return true;
    }
  }
  for (Instant* at : {&begin, &end}) {
    // A bound that is sufficient by itself is not what fails: the way is too long.
    const Sample& sample = at->samples[pair];
    if (sample.level == Level::bodies && !(sample.bound > neededFor(search, pair))) {
      raise(search, pair, *at);
      return true;
    }
  }
  return false;
}

void keepNearer(double bound, const Instant& at, NearPlace& place) noexcept {
  if (bound < place.bound) {
    place = {bound, at.segment, at.share};
  }
}

}  // namespace

void keepNearest(TrajectorySearch& search, LinkPairIndex pair, const PairDistance& distance,
                 const Instant& at, bool is_final) noexcept {
  PairApproach& approach = search.report.pairs[pair];
  const bool was_final = search.is_final[pair] != 0;
  const bool is_nearer = distance.measured.distance < approach.nearest.measured.distance;
  if (is_final != was_final ? is_final : is_nearer) {
    approach.nearest = distance;
    approach.time = timeOf(search, at);
    search.is_final[pair] = is_final ? 1 : 0;
  }
}

void sampleBalls(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                 Instant& at) noexcept {
  at.samples.resize(search.chains.size());
  for (const LinkPairIndex pair : pairs) {
    const double bound = ballDistance(search.measures, pair, at.world_from_link);
    at.samples[pair] = {boundBy(search, pair, bound), Level::balls};
    keepNearer(bound, at, search.by_balls[pair]);
  }
}

void sampleWaypoint(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                    std::size_t waypoint, Instant& at) noexcept {
  sampleBalls(search, pairs, at);
  if (!search.waypoints) {
    return;
  }
  search.measures.steps += measureWaypoint(search.setup, pairs, waypoint, *search.waypoints);
  for (const LinkPairIndex pair : pairs) {
    const double bound = distanceAt(*search.waypoints, waypoint, pair);
    if (bound < search.waypoints->reach) {
      at.samples[pair] = {boundBy(search, pair, bound), Level::bodies};
      keepNearer(bound, at, search.by_waypoints[pair]);
    } else if (bound > at.samples[pair].bound) {
      at.samples[pair].bound = bound;
    }
  }
}

bool settle(TrajectorySearch& search, LinkPairIndex pair, Instant& begin, Instant& end,
            const std::vector<double>& ways) {
  PairApproach& approach = search.report.pairs[pair];
  if (approach.state != ApproachState::clear) {
    return true;
  }
  const double way =
      boundMotion(search.chains[pair], search.measures.balls, begin.world_from_link, ways);
  double bound = 0.0;
  do {
    if (isContact(search, pair, begin)) {
      keepContact(search, pair, begin);
      return true;
    }
    bound = 0.5 * (begin.samples[pair].bound + end.samples[pair].bound - way);
    if (bound > neededFor(search, pair)) {
      approach.at_least = std::min(approach.at_least, bound);
      return true;
    }
  } while (raiseOne(search, pair, begin, end));
  if (way > search.options.tolerance) {
    return false;
  }
  if (isContact(search, pair, end)) {
    keepContact(search, pair, end);
  } else {
    approach.at_least = std::min(approach.at_least, bound);
  }
  return true;
}

void giveUp(TrajectorySearch& search, LinkPairIndex pair, const Instant& at) noexcept {
  PairApproach& approach = search.report.pairs[pair];
  approach.state = ApproachState::undecided;
  approach.time = timeOf(search, at);
  approach.at_least = -kInfinity;
}

}  // namespace collision_monitor
