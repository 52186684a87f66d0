// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "geometry/constants.h"
#include "pipeline/cycle/near_bodies.h"

namespace collision_monitor {
namespace {

bool hasNewLink(const BodyPoses& body_poses, const LastPoses& last) noexcept {
  bool has_new = false;
  for (std::size_t link = 0; link < last.known.size(); ++link) {
    has_new |= body_poses.link_known[link] > last.known[link] ||
               (body_poses.link_known[link] != 0 && body_poses.part[link] != last.part[link]);
  }
  return has_new;
}

void forgetNearest(KnownGaps& gaps) noexcept {
  for (const ElementPairIndex pair : gaps.measured) {
    gaps.nearest[pair] = kInfinity;
  }
  gaps.measured.clear();
}

void forget(KnownGaps& gaps) noexcept {
  std::fill(gaps.of_pair.begin(), gaps.of_pair.end(), -kInfinity);
  forgetNearest(gaps);
}

/// How much a link's rotation has changed since the last cycle, in Frobenius' norm; < 0 if it is
/// not known now or was not then, or has come to another part.
double turnOf(const LinkPoses& poses, const BodyPoses& body_poses, const LastPoses& last,
              std::size_t link) noexcept {
  return hasStayed(last, body_poses, link)
             ? (poses.world_from_link[link].rotation - last.world_from_link[link].rotation).norm()
             : -1.0;
}

/// [m] No point of a ball has come farther. `turn` is that of turnOf; Frobenius' norm
/// also bounds what matrices do that are only nearly rotations.
double stepOf(const Ball& ball, const Eigen::Vector3d& last_center, double turn) noexcept {
  constexpr double kNotRigid = 10.0 * kRigid;  // of the way: what distances of such bodies err by
  constexpr double kRounding = 1e-12;
  const double step = (ball.center - last_center).norm() + turn * ball.radius;
  return step > 0.0 ? (1.0 + kNotRigid) * step + kRounding : 0.0;
}

/// Before ways are so long that adding to them rounds by more than a step allows for.
void beginAnew(const PairTable& table, KnownGaps& gaps) noexcept {
  constexpr double kRounding = 1e-12;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const BodyPair& pair = table.pairs()[i];
    gaps.of_pair[i] -= gaps.ways[index(pair.a)].all + gaps.ways[index(pair.b)].all + kRounding;
  }
  for (BodyWay& way : gaps.ways) {
    way.all = 0.0;
  }
}

/// Of what was measured from `first` on.
void keepNearFrom(const CycleSetup& setup, std::size_t first, CycleBuffers& buffers) noexcept {
  KnownGaps& gaps = buffers.memory.gaps;
  auto& measured = buffers.distances.measured;
  const auto begin = measured.begin() + static_cast<std::ptrdiff_t>(first);
  std::for_each(begin, measured.end(), [&](const PairDistance& distance) {
    const double value = distance.measured.distance;
    rememberGap(value, setup.table[distance.pair], distance.pair, gaps);
    const ElementPairIndex pair = setup.element_pair_of[index(distance.pair)];
    if (value < gaps.nearest[pair]) {
      if (gaps.nearest[pair] == kInfinity) {
        gaps.measured.push_back(pair);
      }
      gaps.nearest[pair] = value;
    }
  });
  const NearBodies near = nearBodies(setup, buffers);
  const auto is_far = [&](const PairDistance& distance) {
    const ElementPairIndex pair = setup.element_pair_of[index(distance.pair)];
    return distance.measured.distance > near.limitOf(distance.pair, gaps.nearest[pair]);
  };
  measured.erase(std::remove_if(begin, measured.end(), is_far), measured.end());
}

}  // namespace

KnownGaps makeKnownGaps(const CycleSetup& setup) {
  KnownGaps gaps;
  gaps.of_pair.resize(setup.table.size(), -kInfinity);
  gaps.ways.resize(setup.bodies.size());
  gaps.nearest.resize(setup.element_pairs.size(), kInfinity);
  gaps.measured.reserve(setup.element_pairs.size());
  return gaps;
}

void followWays(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  constexpr double kLongest = 1000.0;  // [m]
  const BodyPoses& body_poses = buffers.body_poses;
  KnownGaps& gaps = buffers.memory.gaps;
  if (hasNewLink(body_poses, buffers.memory.last)) {
    forget(gaps);
  }
  double longest = 0.0;
  for (std::size_t first = 0; first < setup.bodies.size();) {
    const LinkId link = setup.bodies[first].link;
    const double turn = turnOf(poses, body_poses, buffers.memory.last, index(link));
    double farthest = 0.0;
    std::size_t i = first;
    for (; i < setup.bodies.size() && setup.bodies[i].link == link; ++i) {
      BodyWay& way = gaps.ways[i];
      const Ball& ball = body_poses.balls[i];
      const double step = turn >= 0.0 ? stepOf(ball, way.center, turn) : 0.0;
      way.center = ball.center;
      way.all += step;
      way.ahead = buffers.bounds.ahead[i];
      if (setup.is_continuous && way.ahead < buffers.sweep.body_reach[i]) {
        way.ahead = buffers.sweep.body_reach[i];
      }
      farthest = std::max(farthest, step);
      longest = std::max(longest, way.all);
    }
    for (; first < i; ++first) {
      gaps.ways[first].of_link = farthest;
    }
  }
  if (longest > kLongest) {
    beginAnew(setup.table, gaps);
  }
}

void keepNear(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  forgetNearest(buffers.memory.gaps);
  keepNearFrom(setup, 0, buffers);
}

void measureWaiting(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  const auto isRefined = [&](PairId id) {
    return buffers.refine.is_measured[setup.element_pair_of[index(id)]] != 0;
  };
  auto& waiting = buffers.waiting;
  waiting.erase(std::remove_if(waiting.begin(), waiting.end(), isRefined), waiting.end());
  if (waiting.empty()) {
    return;
  }
  auto& measured = buffers.distances.measured;
  const std::size_t first = measured.size();
  addPairs(setup, buffers.body_poses, waiting, buffers.distances);
  keepNearFrom(setup, first, buffers);
  std::sort(measured.begin(), measured.end(),
            [](const PairDistance& x, const PairDistance& y) { return x.pair < y.pair; });
  buffers.counters.culled_by_gaps -= waiting.size();
}

}  // namespace collision_monitor
