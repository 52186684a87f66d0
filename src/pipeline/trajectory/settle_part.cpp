// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "pipeline/trajectory/trajectory_search.h"

namespace collision_monitor {
namespace {

/// Whether bounds settle a part: no contact, and no distance that must be known.
bool reachesCutoff(const TrajectorySearch& search, LinkPairIndex pair, double bound,
                   double leeway) noexcept {
  return leeway > search.options.tolerance && bound > wantedOf(search, pair);
}

/// [m] If elements are farther apart than this at one end, their part is settled.
double cutoffFor(const TrajectorySearch& search, LinkPairIndex pair, double travel) noexcept {
  return cutoffOf(search, pair) + search.options.tolerance + travel;
}

/// [m] How far the links may travel before they can be in contact.
double travelOf(const Sample& sample) noexcept { return std::min(sample.leeway, sample.outside); }

void raiseToBodies(TrajectorySearch& search, LinkPairIndex pair, Instant& at) noexcept {
  Sample& sample = at.samples[pair];
  const PairDistance distance = bodyDistance(search.measures, pair, at.world_from_link);
  const Sample found = sampleBy(search, pair, distance.measured.distance, Level::bodies);
  sample.bound = std::max(sample.bound, found.bound);
  sample.leeway = std::max(sample.leeway, found.leeway);
  sample.level = Level::bodies;
  keepNearest(search, pair, distance, at, Found::bodies);
}

/// @param cutoff [m] > 0: larger distances are not measured
void raiseToHulls(TrajectorySearch& search, LinkPairIndex pair, double cutoff,
                  Instant& at) noexcept {
  Sample& sample = at.samples[pair];
  const PairDistance distance = hullDistance(search.measures, pair, at.world_from_link, cutoff);
  // If some depth is allowed, each pair of elements must be measured.
  const bool is_final = distance.is_refined && limitsOf(search.setup, pair).contact_distance >= 0.0;
  const Sample found = sampleBy(search, pair, distance.measured.distance, Level::hulls);
  sample.bound = std::max(sample.bound, found.bound);
  sample.leeway = std::max(sample.leeway, found.leeway);
  sample.level = is_final ? Level::elements : Level::hulls;
  const bool is_told = found.bound > wantedOf(search, pair);
  keepNearest(search, pair, distance, at,
              is_final  ? Found::elements
              : is_told ? Found::bounds
                        : Found::bodies);
}

/// @param cutoff [m] > 0: larger distances are not measured
void raiseToElements(TrajectorySearch& search, LinkPairIndex pair, double cutoff,
                     Instant& at) noexcept {
  Sample& sample = at.samples[pair];
  const PairDistance distance = elementDistance(search.measures, pair, at.world_from_link, cutoff);
  // An estimate is a contact at any depth.
  const bool is_overlap = distance.quality == Quality::estimate;
  sample.bound = is_overlap ? -kInfinity : std::max(sample.bound, distance.measured.distance);
  sample.outside = std::max(sample.leeway, search.measures.outside);
  sample.leeway = is_overlap ? -kInfinity : std::max(sample.leeway, search.measures.leeway);
  sample.level = Level::elements;
  sample.is_bound = distance.measured.distance >= cutoff;
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
    search.poses.place(at.segment, at.share, search.report.world_from_link);
  }
}

/// Raises a sample to the level after bodies.
void raiseFromBodies(TrajectorySearch& search, LinkPairIndex pair, double travel,
                     Instant& at) noexcept {
  const bool has_hulls =
      search.measures.has_meshes[pair] != 0 && at.samples[pair].level < Level::hulls;
  (has_hulls ? raiseToHulls : raiseToElements)(search, pair, cutoffFor(search, pair, travel), at);
}

/// The sample to raise next, and whether that measures meshes.
struct NextRaise {
  Instant* at{nullptr};
  Instant* other{nullptr};
  bool is_last{false};
};

/// Chooses the sample whose raising may help to settle the part, cheaper levels first.
NextRaise nextRaise(const TrajectorySearch& search, LinkPairIndex pair, Instant& begin,
                    Instant& end) noexcept {
  const NextRaise ends[] = {{&begin, &end}, {&end, &begin}};
  for (const NextRaise& next : ends) {
    if (next.at->samples[pair].level == Level::balls) {
      return next;
    }
  }
  for (const Level level : {Level::bodies, Level::hulls}) {
    for (const NextRaise& next : ends) {
      // A sample whose bound suffices alone is not at fault: the travel is too long.
      const Sample& sample = next.at->samples[pair];
      if (sample.level == level && !reachesCutoff(search, pair, sample.bound, sample.leeway)) {
        return {next.at, next.other, level == Level::hulls};
      }
    }
  }
  return {};
}

void raise(TrajectorySearch& search, LinkPairIndex pair, double travel,
           const NextRaise& next) noexcept {
  // If bodies did not settle the other end, they mostly do not settle this one.
  const bool skips_bodies =
      next.other->samples[pair].level > Level::bodies ||
      (search.measures.has_meshes[pair] != 0 && asksElementsFirst(search.measures, pair));
  if (next.at->samples[pair].level == Level::balls && !skips_bodies) {
    raiseToBodies(search, pair, *next.at);
  } else {
    raiseFromBodies(search, pair, travel, *next.at);
  }
}

/// Whether to try to prove that elements stay apart: before meshes are measured, and before a part
/// is halved again, if no end is known to be near.
bool asksElements(const TrajectorySearch& search, LinkPairIndex pair, const NextRaise& next,
                  const Instant& begin, const Instant& end, std::size_t depth) noexcept {
  const auto may_be_far = [&](const Instant& at) {
    const Sample& sample = at.samples[pair];
    return sample.level != Level::elements ||
           reachesCutoff(search, pair, sample.bound, sample.leeway);
  };
  return ((next.at == nullptr && depth > 0) || next.is_last) && may_be_far(begin) &&
         may_be_far(end);
}

/// Raises a sample by the bound of another sample minus the travel between these.
void carryOver(const Sample& from, double travel, Sample& to) noexcept {
  if (to.level != Level::elements || to.is_bound) {
    to.bound = std::max(to.bound, from.bound - travel);
    to.leeway = std::max(to.leeway, travelOf(from) - travel);
  }
}

/// [m] A lower bound between two samples, of distances or of travel left until contact.
double between(double begin, double end, double travel) noexcept {
  return 0.5 * (std::max(begin, end - travel) + std::max(end, begin - travel) - travel);
}

/// Settles a pair whose samples show a contact at the beginning, or whose bounds suffice.
bool settleBySamples(TrajectorySearch& search, LinkPairIndex pair, double travel, Instant& begin,
                     Instant& end) {
  if (isContact(search, pair, begin)) {
    keepContact(search, pair, begin);
    return true;
  }
  Sample& at_begin = begin.samples[pair];
  Sample& at_end = end.samples[pair];
  carryOver(at_begin, travel, at_end);
  carryOver(at_end, travel, at_begin);
  const double bound = 0.5 * (at_begin.bound + at_end.bound - travel);
  if (!reachesCutoff(search, pair, bound, 0.5 * (travelOf(at_begin) + travelOf(at_end) - travel))) {
    return false;
  }
  PairApproach& approach = search.report.pairs[pair];
  approach.at_least = std::min(approach.at_least, bound);
  return true;
}

/// Settles a pair that hardly moves and is measured.
/// @param travel [m] at most the tolerance
bool settleStanding(TrajectorySearch& search, LinkPairIndex pair, double travel,
                    const Instant& at) {
  if (isContact(search, pair, at)) {
    keepContact(search, pair, at);
  } else {
    PairApproach& approach = search.report.pairs[pair];
    approach.at_least = std::min(approach.at_least, at.samples[pair].bound - travel);
  }
  return true;
}

}  // namespace

double cutoffOf(const TrajectorySearch& search, LinkPairIndex pair) noexcept {
  const double contact = std::max(0.0, limitsOf(search.setup, pair).contact_distance);
  return std::max(wantedOf(search, pair), contact + search.options.tolerance);
}

bool settleFar(TrajectorySearch& search, LinkPairIndex pair, const Instant& begin,
               const Instant& end, const std::vector<double>& travels) noexcept {
  PairApproach& approach = search.report.pairs[pair];
  if (approach.state != ApproachState::clear) {
    return true;
  }
  const Sample& at_begin = begin.samples[pair];
  const Sample& at_end = end.samples[pair];
  // boundMotion takes time: skips it if the larger sample does not suffice.
  if (!reachesCutoff(search, pair, std::max(at_begin.bound, at_end.bound),
                     std::max(travelOf(at_begin), travelOf(at_end)))) {
    return false;
  }
  const double travel = boundMotion(search.chains[pair], travels, search.levers);
  const double bound = between(at_begin.bound, at_end.bound, travel);
  if (!reachesCutoff(search, pair, bound, between(travelOf(at_begin), travelOf(at_end), travel))) {
    return false;
  }
  approach.at_least = std::min(approach.at_least, bound);
  return true;
}

bool settle(TrajectorySearch& search, LinkPairIndex pair, Instant& begin, Instant& end,
            Halving& halving) {
  if (search.report.pairs[pair].state != ApproachState::clear) {
    return true;
  }
  const double travel = boundMotion(search.chains[pair], halving.travels, search.levers);
  const bool is_moving = travel > search.options.tolerance;
  bool asks = is_moving;
  while (!settleBySamples(search, pair, travel, begin, end)) {
    const NextRaise next = nextRaise(search, pair, begin, end);
    if (asks && asksElements(search, pair, next, begin, end, halving.depth)) {
      asks = false;
      const Level level = next.is_last ? Level::elements : Level::hulls;
      placeMiddle(search, begin, end, halving);
      if (settleMoving(search, pair, level, halving.middle, halving.steps)) {
        search.proven_by[pair] = level;
        return true;
      }
      search.proven_by[pair] = Level::balls;
    }
    if (next.at == nullptr) {
      return !is_moving && settleStanding(search, pair, travel, end);
    }
    raise(search, pair, travel, next);
  }
  return true;
}

}  // namespace collision_monitor
