// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/trajectory_search.h"

#include <algorithm>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

/// Whether bounds settle a part of the way: no contact, and nothing nearer that must be known.
bool isEnough(const TrajectorySearch& search, LinkPairIndex pair, double bound,
              double leeway) noexcept {
  const double found =
      search.is_final[pair] != 0 ? search.report.pairs[pair].nearest.measured.distance : kInfinity;
  return leeway > search.options.tolerance &&
         bound > std::min(search.options.margin, found - search.options.resolution);
}

/// What balls or bodies say of elements. Where some depth is allowed, those that overlap say
/// nothing: see contactOfBodies.
Sample sampleBy(const TrajectorySearch& search, double distance, Level level) noexcept {
  const double contact = search.setup.limits.contact_distance;
  const double bound = distance > 0.0 || contact >= 0.0 ? distance : -kInfinity;
  return {bound, bound - std::max(0.0, contact), level, kInfinity};
}

/// [m] How far the links may go until they are in contact.
double wayOf(const Sample& sample) noexcept { return std::min(sample.leeway, sample.outside); }

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
  const Sample found =
      is_final ? Sample{distance.measured.distance, search.measures.leeway, Level::elements,
                        std::max(sample.leeway, search.measures.outside)}
               : sampleBy(search, distance.measured.distance, Level::bodies);
  // An estimate of a depth is a contact, however deep that may be allowed to be.
  const bool is_overlap = distance.quality == Quality::estimate;
  sample.bound = is_overlap ? -kInfinity : std::max(sample.bound, found.bound);
  sample.leeway = is_overlap ? -kInfinity : std::max(sample.leeway, found.leeway);
  sample.level = found.level;
  sample.outside = found.outside;
  keepNearest(search, pair, distance, at, is_final);
}

bool isContact(const TrajectorySearch& search, LinkPairIndex pair, const Instant& at) noexcept {
  const Sample& sample = at.samples[pair];
  return sample.level == Level::elements && sample.leeway <= search.options.tolerance;
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
    if (sample.level == Level::bodies && !isEnough(search, pair, sample.bound, sample.leeway)) {
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
    at.samples[pair] = sampleBy(search, bound, Level::balls);
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
      at.samples[pair] = sampleBy(search, bound, Level::bodies);
      keepNearer(bound, at, search.by_waypoints[pair]);
    } else if (bound > at.samples[pair].bound) {
      at.samples[pair] = sampleBy(search, bound, at.samples[pair].level);
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
    const Sample& at_begin = begin.samples[pair];
    const Sample& at_end = end.samples[pair];
    bound = 0.5 * (at_begin.bound + at_end.bound - way);
    if (isEnough(search, pair, bound, 0.5 * (wayOf(at_begin) + wayOf(at_end) - way))) {
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
