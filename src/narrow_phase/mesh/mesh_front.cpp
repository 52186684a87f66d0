// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_front.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/ball_motion.h"

namespace collision_monitor {
namespace {

using Kept = MeshFront::Kept;

// The margin: steps, or the share of the distance if that is more.
constexpr double kSteps = 32.0;
constexpr double kShare = 0.05;
// Where there is no room for a margin of so many steps, keeping pairs costs more than it saves.
constexpr double kFewestSteps = 4.0;
// Room grows by this at every search from the roots: what was too much is tried again in time.
constexpr double kRoomGrowth = 1.05;

constexpr double kUlp = std::numeric_limits<float>::epsilon();

// To bound a pair anew takes a part of what opening one does.
constexpr std::uint32_t kBoundsPerVisit = 2;

bool isNearer(const Kept& one, const Kept& other) noexcept { return one.due < other.due; }

// Leaves half of the room to those that are nearest, and asks for fewer.
void makeRoom(MeshFront& front) noexcept {
  const auto begin = front.kept.begin();
  const auto middle = begin + MeshFront::kCapacity / 2;
  std::nth_element(begin, middle, begin + front.size, isNearer);
  front.cover = std::min(front.cover, static_cast<double>(middle->due));
  front.size = MeshFront::kCapacity / 2;
  front.margin *= 0.5;
  front.room = front.margin;
}

// [m^2] Where the meshes are now.
float boundOfPair(const MeshPair& pair, std::uint32_t a, std::uint32_t b) noexcept {
  NodeBounds bounds;
  boundNearer(pair.a.nodes()[a >> kSlotBits], place(pair.bounds_to_a, boundAt(pair.b, b)), 0.0F,
              bounds);
  return bounds.squared[a & (MeshTreeNode::kWidth - 1)];
}

// [m^2] As far as it was known, less the motion since.
float oldBoundOf(const Kept& kept, const MeshFront& front) noexcept {
  const double bound = std::max(static_cast<double>(kept.due) - front.moved, 0.0);
  return static_cast<float>(bound * bound * (1.0 - kUlp));
}

float dueOf(double squared_bound, const MeshFront& front) noexcept {
  return static_cast<float>((std::sqrt(squared_bound) + front.moved) * (1.0 - kUlp));
}

// The nearest so far stays on top. @return its bound.
float pushNearest(MeshQueryMemory::Waiting next, float least, WaitingPairs& waiting) noexcept {
  if (next.squared_bound > least) {
    const MeshQueryMemory::Waiting nearest = waiting.pop();
    waiting.push(next);
    next = nearest;
  }
  waiting.push(next);
  return next.squared_bound;
}

}  // namespace

double follow(const MeshPair& pair, MeshFront& front) noexcept {
  double step = std::numeric_limits<double>::infinity();
  if (front.a_from_b) {
    const double of_b =
        motionOfBall(pair.b.center(), pair.b.radius(), *front.a_from_b, pair.a_from_b);
    const double of_a = motionOfBall(pair.a.center(), pair.a.radius(), inverse(*front.a_from_b),
                                     inverse(pair.a_from_b));
    step = std::min(of_a, of_b) + pair.rounding;
  }
  front.a_from_b = pair.a_from_b;
  front.moved += step;
  return step;
}

bool covers(const MeshFront& front, double squared_distance) noexcept {
  return std::sqrt(squared_distance) <= front.cover - front.moved;
}

TakenPairs takeNearer(const MeshPair& pair, double squared_goal, std::uint32_t visit_budget,
                      MeshFront& front, WaitingPairs& waiting) noexcept {
  const auto now = static_cast<float>((std::sqrt(squared_goal) + front.moved) * (1.0 + kUlp));
  const float limit = asLimit(squared_goal);
  double least_due = front.cover;
  float least_taken = std::numeric_limits<float>::infinity();
  std::uint32_t kept = 0;
  std::uint32_t bounded = 0;
  const std::uint32_t most = visit_budget / 2 * kBoundsPerVisit;  // the other half opens pairs
  for (std::uint32_t i = 0; i < front.size; ++i) {
    Kept& of_pair = front.kept[i];
    if (of_pair.due < now) {
      float squared_bound = oldBoundOf(of_pair, front);
      if (bounded < most) {
        ++bounded;
        squared_bound = std::max(squared_bound, boundOfPair(pair, of_pair.a, of_pair.b));
      }
      if (squared_bound < limit) {
        least_taken = pushNearest({squared_bound, of_pair.a, of_pair.b}, least_taken, waiting);
        continue;
      }
      of_pair.due = dueOf(static_cast<double>(squared_bound), front);
    }
    least_due = std::min(least_due, static_cast<double>(of_pair.due));
    front.kept[kept++] = of_pair;
  }
  front.size = kept;
  const double bound = std::max(least_due - front.moved, 0.0);
  return {bound * bound, bounded / kBoundsPerVisit};
}

void restart(double step, double squared_distance, MeshFront& front) noexcept {
  front.size = 0;
  front.moved = 0.0;
  front.cover = std::numeric_limits<double>::infinity();
  front.room *= kRoomGrowth;
  const double wanted = std::max(kSteps * step, kShare * std::sqrt(squared_distance));
  front.margin = std::min(wanted, front.room);
  if (!std::isfinite(wanted) || front.margin < kFewestSteps * step) {
    front.margin = 0.0;
  }
}

double squaredReach(double squared_distance, MeshFront& front) noexcept {
  const double nearest = std::sqrt(squared_distance);
  front.cover = std::min(front.cover, nearest + front.margin + front.moved);
  const double reach = std::max(front.cover - front.moved, nearest);
  return reach * reach;
}

void keep(std::uint32_t a, std::uint32_t b, double squared_bound, MeshFront& front) noexcept {
  const float due = dueOf(squared_bound, front);
  if (due < front.cover && front.size == MeshFront::kCapacity) {
    makeRoom(front);
  }
  if (due < front.cover) {
    front.kept[front.size++] = {due, a, b};
  }
}

}  // namespace collision_monitor
