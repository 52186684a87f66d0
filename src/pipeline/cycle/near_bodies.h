// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/constants.h"
#include "motion/closing_bound.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/distance_cache.h"

namespace collision_monitor {

/// How near the bodies of a pair must be to matter.
struct NearBodies {
  const CycleSetup& setup;
  const LinkVelocities& velocities;
  const std::vector<Ball>& balls;  ///< as BodyPoses
  const ActivationDistances& reaches;
  const RobotSpeeds& robots;
  const DistanceCache& cache;
  const std::vector<double>& body_travel;  ///< as SweepWork
  const std::vector<double>& told_below;   ///< as RefineWork
  const std::vector<Verdict>& reported;    ///< as PairMemory

  /// What is looked up of a pair, gathered.
  ElementsPlace placeOf(PairId id) const noexcept {
    const std::uint32_t link_pair = setup.link_pair_of[index(id)];
    return {setup.table[id].a,
            setup.table[id].b,
            setup.element_pair_of[index(id)],
            link_pair,
            reaches.place_of[link_pair],
            setup.own_limits.empty() ? 0 : setup.checked[link_pair].limits};
  }

  /// [m] At or below this distance bodies matter whatever other bodies of their elements do. It is
  /// the lesser of two bounds: by the motion of both links, and by the motion of both bodies.
  double nearOf(const ElementsPlace& pair) const noexcept {
    const PairReach& reach = reaches.of_limits[pair.limits];
    return nearOf({byLinks(pair), reach.near, reach.stop}, pair.a, pair.b);
  }

  /// The two bounds: by links, and at rest or from a stop on.
  struct Bounds {
    double by_links;
    double at_rest;
    double stop;
  };
  double nearOf(const Bounds& bounds, BodyId a, BodyId b) const noexcept {
    const double ahead = cache.travels[index(a)].ahead + cache.travels[index(b)].ahead;
    // `ahead` may be NaN: by the order of arguments the result is then the other bound.
    return std::min(bounds.by_links, std::max(bounds.stop + ahead, bounds.at_rest));
  }

  /// [m] As nearOf, for any bodies of these links.
  double byLinks(const ElementsPlace& pair) const noexcept {
    return std::max(reaches.of_limits[pair.limits].near, reaches.motion[pair.reach_place]);
  }

  /// [m] At or below this distance somebody may be told how near the links are: up to all that is
  /// reported where a warning or contact may end, and of RobotSpeeds::closing.
  double heardOf(const ElementsPlace& pair) const noexcept {
    const bool is_clear = reported[pair.link_pair] == Verdict::clear;
    return is_clear && pair.elements != robots.closing ? toldOf(pair)
                                                       : reaches.of_limits[pair.limits].all;
  }

  /// [m] As heardOf, of pairs whose verdict does not change.
  double toldOf(const ElementsPlace& pair) const noexcept {
    const double told = std::max(reaches.told[pair.reach_place], told_below[pair.link_pair]);
    return std::min(reaches.of_limits[pair.limits].all, told);
  }

  /// [m] nearOf and heardOf are not above this for bodies with these travels, whatever pair they
  /// are. NaN if a motion ahead is unknown.
  double highestLimitOf(const BodyTravel& a, const BodyTravel& b) const noexcept {
    const PairReach& farthest = reaches.farthest;
    return std::max(farthest.stop + (a.ahead + b.ahead), std::max(farthest.all, farthest.near));
  }

  /// Whether bodies this far apart do not matter.
  /// @param nearest [m] the distance of the nearest bodies of their elements: no farther ones are
  /// told
  bool isFar(const ElementsPlace& pair, double nearest, double distance) const noexcept {
    return distance > atRest(pair, nearest) && !closes(pair, distance);
  }

  /// Whether bodies this far apart may matter because they move.
  bool closes(const ElementsPlace& pair, double distance) const noexcept {
    return !(distance > nearOf(pair)) &&
           !(passesLone(pair) && distance > byClosing(pair, closingOf(pair)));
  }

  /// Whether bodies are lone and are passed over by how they close.
  bool passesLone(const ElementsPlace& pair) const noexcept {
    return robots.passes_lone && areLone(cache, pair) && !isSought(pair);
  }

  /// Whether lone bodies matter as all others do, since a speed scale does not jump while they
  /// close or rest.
  bool isSought(const ElementsPlace& pair) const noexcept {
    return pair.elements == robots.closing || (robots.seeks_closing && !parts(pair));
  }

  /// Whether isSought may hold for some bodies of these links.
  bool seeksAmong(LinkPairIndex links) const noexcept {
    return robots.seeks_closing ||
           (robots.closing != kNone && setup.element_pairs[robots.closing].link_pair == links);
  }

  /// [m] How far apart the nearest lone bodies of their links are; before measureDeferred, how far
  /// they were in the last cycle. Infinite for other bodies.
  double nearestOfLone(const ElementsPlace& pair) const noexcept {
    return passesLone(pair) ? cache.nearest_of_links[pair.link_pair] : kInfinity;
  }

  /// [m] Bodies at or below this distance matter even if nothing moves. Of lone bodies, only the
  /// nearest of their links do, even where pairs are refined or warned of.
  double atRest(const ElementsPlace& pair, double nearest) const noexcept {
    const double of_all =
        std::max(reaches.of_limits[pair.limits].near, std::min(heardOf(pair), nearest));
    return passesLone(pair) ? std::min(of_all, farthestOfLinks(pair)) : of_all;
  }

  /// [m] An upper bound of the distance of their links: see DistanceCache::links.
  double farthestOfLinks(const ElementsPlace& pair) const noexcept;

  /// How B's link moves, seen from A, and how far ahead that matters.
  struct Closing {
    bool is_known;
    Twist b_from_a;
    double time;    ///< [s] ahead
    double judged;  ///< [m] how far the links may close within contact_time or warning_time
  };
  Closing closingOf(const ElementsPlace& pair) const noexcept;

  /// [m/s] As closingBound of the balls of two bodies; infinite where a velocity is not known.
  double closingSpeed(const ElementsPlace& pair, const Closing& closing) const noexcept {
    return closing.is_known
               ? closingBound(balls[index(pair.a)], balls[index(pair.b)], closing.b_from_a)
               : kInfinity;
  }

  /// Whether bodies part, faster than what counts as resting.
  bool parts(const ElementsPlace& pair) const noexcept {
    constexpr double kRounding = 1e-9;
    return closingSpeed(pair, closingOf(pair)) < -setup.ahead.stop.rest_speed - kRounding;
  }

  /// [m] As nearOf, by closingSpeed: what a scale or a time may follow from, and what may have
  /// touched since the last cycle. Where a verdict may follow from a time, bodies that are nearer
  /// than those that cause it still matter. Where a velocity is not known, a pair has no
  /// time to contact, and its scale follows from its distance: the nearest bodies ask for the
  /// lowest. Only lone bodies are asked: this takes a third of the time of a measurement, and says
  /// little of bodies that are near for their size.
  double byClosing(const ElementsPlace& pair, const Closing& closing) const noexcept;
};

inline NearBodies::Closing NearBodies::closingOf(const ElementsPlace& pair) const noexcept {
  const CheckedLinkPair& links = setup.checked[pair.link_pair];
  const double verdict_time = std::max(reaches.contact_time, reaches.warning_time);
  const std::size_t a = index(links.a);
  const std::size_t b = index(links.b);
  return {velocities.known[a] != 0 && velocities.known[b] != 0,
          velocities.of_link[b] - velocities.of_link[a],
          std::max(robots.watched[robots.robot_of_link[a]].time,
                   robots.watched[robots.robot_of_link[b]].time),
          verdict_time > 0.0 ? verdict_time * reaches.speed[pair.reach_place] : 0.0};
}

inline double NearBodies::byClosing(const ElementsPlace& pair,
                                    const Closing& closing) const noexcept {
  constexpr double kRounding = 1e-9;
  const PairReach& reach = reaches.of_limits[pair.limits];
  const double came =
      std::max(reach.contact, 0.0) + body_travel[index(pair.a)] + body_travel[index(pair.b)];
  if (!closing.is_known) {
    return std::max(reach.stop, came);
  }
  const double speed = closingSpeed(pair, closing);
  const double asked = reach.stop + closing.time * std::max(speed, 0.0) + kRounding;
  const double judged = reach.stop + closing.judged;
  return std::isfinite(speed) && std::isfinite(judged) ? std::max({asked, came, judged})
                                                       : kInfinity;
}

inline NearBodies nearBodies(const CycleSetup& setup, const LinkPoses& poses,
                             const CycleBuffers& buffers) noexcept {
  return {setup,
          poses.velocities,
          buffers.body_poses.balls,
          buffers.activation,
          buffers.robots,
          buffers.memory.distance_cache,
          buffers.sweep.body_travel,
          buffers.refine.told_below,
          buffers.memory.reported};
}

inline double NearBodies::farthestOfLinks(const ElementsPlace& pair) const noexcept {
  constexpr double kRounding = 1e-9;  // of both distances
  return cache.links[pair.link_pair] + travelOfLinks(cache, pair) + kRounding;
}

}  // namespace collision_monitor
