// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/trajectory_search.h"

#include <algorithm>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

/// [m] What is farther apart need not be known.
double wantedOf(const TrajectorySearch& search, LinkPairIndex pair) noexcept {
  const double nearest = search.found[pair] == Found::elements
                             ? search.report.pairs[pair].nearest.measured.distance
                             : kInfinity;
  return std::min(search.options.margin, nearest - search.options.resolution);
}

/// Whether bounds settle a part of the way: no contact, and nothing nearer that must be known.
bool isEnough(const TrajectorySearch& search, LinkPairIndex pair, double bound,
              double leeway) noexcept {
  return leeway > search.options.tolerance && bound > wantedOf(search, pair);
}

/// [m] Elements that are so far apart settle a part of the way by themselves.
double enoughFor(const TrajectorySearch& search, LinkPairIndex pair, double way) noexcept {
  const double contact = std::max(0.0, search.setup.limits.contact_distance);
  return std::max(wantedOf(search, pair), contact + search.options.tolerance) +
         search.options.tolerance + way;
}

/// What balls or bodies say of elements. Where some depth is allowed, those that overlap say
/// nothing: see contactOfBodies.
Sample sampleBy(const TrajectorySearch& search, double distance, Level level) noexcept {
  const double contact = search.setup.limits.contact_distance;
  const double bound = distance > 0.0 || contact >= 0.0 ? distance : -kInfinity;
  return {bound, bound - std::max(0.0, contact), level, false, kInfinity};
}

/// [m] How far the links may go until they are in contact.
double wayOf(const Sample& sample) noexcept { return std::min(sample.leeway, sample.outside); }

double timeOf(const TrajectorySearch& search, const Instant& at) noexcept {
  return timeAt(search.path, at.segment, at.share);
}

void raiseToBodies(TrajectorySearch& search, LinkPairIndex pair, Instant& at) noexcept {
  Sample& sample = at.samples[pair];
  const PairDistance distance = bodyDistance(search.measures, pair, at.world_from_link);
  const Sample found = sampleBy(search, distance.measured.distance, Level::bodies);
  sample.bound = std::max(sample.bound, found.bound);
  sample.leeway = std::max(sample.leeway, found.leeway);
  sample.level = Level::bodies;
  keepNearest(search, pair, distance, at, Found::bodies);
}

/// @param enough [m] > 0: farther apart is not measured
void raiseToElements(TrajectorySearch& search, LinkPairIndex pair, double enough,
                     Instant& at) noexcept {
  Sample& sample = at.samples[pair];
  const PairDistance distance = elementDistance(search.measures, pair, at.world_from_link, enough);
  // An estimate of a depth is a contact, however deep that may be allowed to be.
  const bool is_overlap = distance.quality == Quality::estimate;
  sample.bound = is_overlap ? -kInfinity : std::max(sample.bound, distance.measured.distance);
  sample.outside = std::max(sample.leeway, search.measures.outside);
  sample.leeway = is_overlap ? -kInfinity : std::max(sample.leeway, search.measures.leeway);
  sample.level = Level::elements;
  sample.is_bound = distance.measured.distance >= enough;
  keepNearest(search, pair, distance, at, sample.is_bound ? Found::bounds : Found::elements);
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
bool raiseOne(TrajectorySearch& search, LinkPairIndex pair, double way, Instant& begin,
              Instant& end) noexcept {
  for (Instant* at : {&begin, &end}) {
    if (at->samples[pair].level == Level::balls) {
      raiseToBodies(search, pair, *at);
      return true;
    }
  }
  for (Instant* at : {&begin, &end}) {
    // A bound that is sufficient by itself is not what fails: the way is too long.
    const Sample& sample = at->samples[pair];
    if (sample.level == Level::bodies && !isEnough(search, pair, sample.bound, sample.leeway)) {
      raiseToElements(search, pair, enoughFor(search, pair, way), *at);
      return true;
    }
  }
  return false;
}

/// What a sample says of another time, up to which the links go a way.
void carryOver(const Sample& from, double way, Sample& to) noexcept {
  if (to.level != Level::elements || to.is_bound) {
    to.bound = std::max(to.bound, from.bound - way);
    to.leeway = std::max(to.leeway, wayOf(from) - way);
  }
}

/// [m] A lower bound on the way between two samples, or of what is left of it until contact.
double between(double begin, double end, double way) noexcept {
  return 0.5 * (std::max(begin, end - way) + std::max(end, begin - way) - way);
}

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

/// Measures the elements of a pair if they may be nearer than all that is known of it.
void lookForNearer(TrajectorySearch& search, LinkPairIndex pair, double bound, Instant& at) {
  const double wanted = wantedOf(search, pair);
  if (!(wanted > 0.0) || bound > wanted) {
    return;
  }
  place(search, at);
  const PairDistance found = elementDistance(search.measures, pair, at.world_from_link, wanted);
  if (found.measured.distance < wanted) {
    keepNearest(search, pair, found, at, Found::elements);
  }
}

}  // namespace

void keepNearest(TrajectorySearch& search, LinkPairIndex pair, const PairDistance& distance,
                 const Instant& at, Found found) noexcept {
  PairApproach& approach = search.report.pairs[pair];
  Found& last = search.found[pair];
  const bool is_nearer = distance.measured.distance < approach.nearest.measured.distance;
  if (found != last ? found > last : is_nearer) {
    approach.nearest = distance;
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
    at.samples[pair] = sampleBy(search, ballsApart(search, pair, at), Level::balls);
  }
}

std::size_t lookAhead(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                      std::size_t waypoint) {
  const std::size_t count = search.path.times.size();
  if (!search.waypoints) {
    return count;
  }
  WaypointDistances& distances = *search.waypoints;
  const std::uint64_t steps = measureWaypoint(search.setup, pairs, waypoint, distances);
  search.measures.steps += steps;
  Instant at;
  for (const LinkPairIndex pair : steps > 0 ? pairs : std::vector<LinkPairIndex>()) {
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
      at.samples[pair] = sampleBy(search, bound, Level::bodies);
    } else if (bound > at.samples[pair].bound) {
      at.samples[pair] = sampleBy(search, bound, at.samples[pair].level);
    }
  }
}

bool settleFar(TrajectorySearch& search, LinkPairIndex pair, const Instant& begin,
               const Instant& end, const std::vector<double>& ways) noexcept {
  PairApproach& approach = search.report.pairs[pair];
  if (approach.state != ApproachState::clear) {
    return true;
  }
  const Sample& at_begin = begin.samples[pair];
  const Sample& at_end = end.samples[pair];
  // The way takes time to bound.
  if (!isEnough(search, pair, std::max(at_begin.bound, at_end.bound),
                std::max(wayOf(at_begin), wayOf(at_end)))) {
    return false;
  }
  const double way =
      boundMotion(search.chains[pair], search.measures.balls, begin.world_from_link, ways);
  const double bound = between(at_begin.bound, at_end.bound, way);
  if (!isEnough(search, pair, bound, between(wayOf(at_begin), wayOf(at_end), way))) {
    return false;
  }
  approach.at_least = std::min(approach.at_least, bound);
  return true;
}

bool settle(TrajectorySearch& search, LinkPairIndex pair, Instant& begin, Instant& end,
            const std::vector<double>& ways) {
  PairApproach& approach = search.report.pairs[pair];
  if (approach.state != ApproachState::clear) {
    return true;
  }
  const double way =
      boundMotion(search.chains[pair], search.measures.balls, begin.world_from_link, ways);
  Sample& at_begin = begin.samples[pair];
  Sample& at_end = end.samples[pair];
  double bound = 0.0;
  do {
    if (isContact(search, pair, begin)) {
      keepContact(search, pair, begin);
      return true;
    }
    carryOver(at_begin, way, at_end);
    carryOver(at_end, way, at_begin);
    bound = 0.5 * (at_begin.bound + at_end.bound - way);
    if (isEnough(search, pair, bound, 0.5 * (wayOf(at_begin) + wayOf(at_end) - way))) {
      approach.at_least = std::min(approach.at_least, bound);
      return true;
    }
  } while (raiseOne(search, pair, way, begin, end));
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
