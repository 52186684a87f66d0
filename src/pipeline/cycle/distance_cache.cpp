// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/distance_cache.h"

#include <algorithm>

#include "geometry/constants.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/look_ahead/find_motions.h"

namespace collision_monitor {
namespace {

bool hasNewLink(const BodyPoses& body_poses, const PlacedLinks& last) noexcept {
  bool has_new = false;
  forIndices(body_poses.moved.links, [&](std::size_t link) noexcept {
    has_new |= body_poses.link_known[link] > last.known[link] ||
               (body_poses.link_known[link] != 0 && body_poses.part[link] != last.part[link]);
  });
  return has_new;
}

/// The Frobenius norm of the change of a link's rotation since then; < 0 if the link was not known,
/// is not known now, or is in another part.
double turnOf(const LinkPoses& poses, const BodyPoses& body_poses, const PlacedLinks& last,
              std::size_t link) noexcept {
  return hasStayed(last, body_poses, link)
             ? (poses.world_from_link[link].rotation - last.world_from_link[link].rotation).norm()
             : -1.0;
}

/// [m] An upper bound of how far any point of the ball has moved since then. `turn` comes
/// from turnOf; a Frobenius norm also bounds matrices that are only nearly rotations.
double stepOf(const Ball& ball, const Eigen::Vector3d& last_center, double turn) noexcept {
  constexpr double kNotRigid = 10.0 * kRigid;  // share of travel: their distances' error
  constexpr double kRounding = 1e-12;
  const double step = (ball.center - last_center).norm() + turn * ball.radius;
  return step > 0.0 ? (1.0 + kNotRigid) * step + kRounding : 0.0;
}

/// Resets travels before they get so long that sums round by more than stepOf allows for.
void beginAnew(const PairTable& table, DistanceCache& cache) noexcept {
  constexpr double kRounding = 1e-12;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const BodyPair& pair = table.pairs()[i];
    cache.distances[i] -=
        cache.travels[index(pair.a)].all + cache.travels[index(pair.b)].all + kRounding;
  }
  for (BodyTravel& travel : cache.travels) {
    travel.all = travel.of_link_all = 0.0;
  }
  std::fill(cache.elements.begin(), cache.elements.end(), -kInfinity);
  std::fill(cache.links.begin(), cache.links.end(), kInfinity);
  cache.is_listed = false;
}

/// For the bodies of one link, from `first` on. @return one after the last of them.
std::size_t accumulateOfLink(const CycleSetup& setup, double turn, std::size_t first,
                             CycleBuffers& buffers) noexcept {
  DistanceCache& cache = buffers.memory.distance_cache;
  const LinkId link = setup.bodies[first].link;
  double farthest = 0.0;
  std::size_t last = first;
  for (; last < setup.bodies.size() && setup.bodies[last].link == link; ++last) {
    BodyTravel& travel = cache.travels[last];
    const Ball& ball = buffers.body_poses.balls[last];
    const double step = turn >= 0.0 ? stepOf(ball, travel.center, turn) : 0.0;
    travel.center = ball.center;
    travel.all += step;
    travel.ahead = buffers.bounds.ahead[last];
    farthest = std::max(farthest, step);
    if (setup.is_continuous) {
      const double on_way = buffers.sweep.body_travel[last];
      travel.ahead = travel.ahead < on_way ? on_way : travel.ahead;  // a NaN stays one
      farthest = std::max(farthest, on_way);
    }
  }
  for (; first < last; ++first) {
    cache.travels[first].of_link = farthest;
    cache.travels[first].of_link_all += farthest;
    cache.longest = std::max(cache.longest, cache.travels[first].of_link_all);
  }
  return last;
}

std::vector<unsigned char> findLone(const CycleSetup& setup) {
  std::vector<std::uint32_t> of_element(setup.elements.size(), 0);
  std::vector<std::uint32_t> of_link(setup.model.links.size(), 0);
  for (const Body& body : setup.bodies) {
    ++of_element[index(body.element)];
    ++of_link[index(body.link)];
  }
  std::vector<unsigned char> lone;
  lone.reserve(setup.bodies.size());
  for (const Body& body : setup.bodies) {
    const int several = of_link[index(body.link)] > 1 ? kOfSeveral : 0;
    lone.push_back(
        static_cast<unsigned char>(of_element[index(body.element)] == 1 ? kLone | several : 0));
  }
  return lone;
}

/// Forgets all distances. Travel stays; so does `nearest_of_links`, which until measureDeferred
/// only says what to measure first.
void forgetDistances(DistanceCache& cache) noexcept {
  std::fill(cache.distances.begin(), cache.distances.end(), -kInfinity);
  std::fill(cache.elements.begin(), cache.elements.end(), -kInfinity);
  std::fill(cache.links.begin(), cache.links.end(), kInfinity);
  cache.is_listed = false;
  forgetNearest(cache);
}

}  // namespace

void forgetNearest(DistanceCache& cache) noexcept {
  for (const ElementPairIndex pair : cache.measured_pairs) {
    cache.nearest[pair] = kInfinity;
  }
  cache.measured_pairs.clear();
}

void forgetNearestOfLinks(DistanceCache& cache) noexcept {
  for (const std::uint32_t pair : cache.measured_links) {
    cache.nearest_of_links[pair] = kInfinity;
  }
  cache.measured_links.clear();
}

DistanceCache makeDistanceCache(const CycleSetup& setup) {
  DistanceCache cache;
  cache.distances.resize(setup.table.size(), -kInfinity);
  cache.travels.resize(setup.bodies.size());
  const std::size_t links = setup.model.links.size();
  cache.placed.world_from_link.resize(links);
  cache.placed.known.resize(links, 0);
  cache.placed.part.resize(links, kWorldPart);
  cache.nearest.resize(setup.element_pairs.size(), kInfinity);
  cache.elements.resize(setup.element_pairs.size(), -kInfinity);
  cache.links.resize(setup.checked.size(), kInfinity);
  cache.measured_pairs.reserve(setup.element_pairs.size());
  cache.nearest_of_links.resize(setup.checked.size(), kInfinity);
  cache.measured_links.reserve(setup.checked.size());
  cache.listed.reserve(setup.table.size());
  cache.groups.reserve(setup.element_pairs.size());
  cache.marks = MarkedPairs(setup.table.size());
  cache.group_of.resize(setup.element_pairs.size(), kNone);
  cache.group_of_lone.resize(setup.checked.size(), kNone);
  cache.lone = findLone(setup);
  cache.has_lone =
      std::find(cache.lone.begin(), cache.lone.end(), kLone | kOfSeveral) != cache.lone.end();
  cache.listed_moved.reserve(setup.carried.size() + 1);
  return cache;
}

void accumulateTravel(const CycleSetup& setup, const LinkPoses& poses,
                      CycleBuffers& buffers) noexcept {
  constexpr double kLongest = 1000.0;  // [m]
  const BodyPoses& body_poses = buffers.body_poses;
  DistanceCache& cache = buffers.memory.distance_cache;
  if (hasNewLink(body_poses, cache.placed)) {
    forgetDistances(cache);
  }
  cache.longest = 0.0;
  for (const IndexRange& bodies : body_poses.moved.bodies) {
    for (std::size_t first = bodies.first; first < bodies.last;) {
      const std::size_t link = index(setup.bodies[first].link);
      const double turn = turnOf(poses, body_poses, cache.placed, link);
      first = accumulateOfLink(setup, turn, first, buffers);
    }
  }
  keepLinks(poses, body_poses, cache.placed);
  if (cache.longest > kLongest) {
    beginAnew(setup.table, cache);
  }
}

}  // namespace collision_monitor
