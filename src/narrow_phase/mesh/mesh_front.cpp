// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_front.h"

#include <algorithm>
#include <cmath>

#include "geometry/ball_motion.h"

namespace collision_monitor {
namespace {

using Kept = MeshFront::Kept;

// The margin: steps, or the share of the distance if that is more.
constexpr double kSteps = 16.0;
constexpr double kShare = 0.05;
// Where there is no room for a margin of so many steps, keeping pairs costs more than it saves.
constexpr double kFewestSteps = 4.0;
// Room grows by this at every search from the roots: what was too much is tried again in time.
constexpr double kRoomGrowth = 1.05;

constexpr double kUlp = std::numeric_limits<float>::epsilon();

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

void takeNearer(double squared_distance, MeshFront& front, WaitingPairs& waiting) noexcept {
  const auto now = static_cast<float>((std::sqrt(squared_distance) + front.moved) * (1.0 + kUlp));
  // Those that are due come last, and of these the nearest.
  const auto begin = front.kept.begin();
  const auto due = std::partition(begin, begin + front.size,
                                  [now](const Kept& kept) { return !(kept.due < now); });
  const auto end = begin + front.size;
  const auto nearest = std::min_element(due, end, isNearer);
  if (nearest != end) {
    std::iter_swap(nearest, end - 1);
  }
  for (auto kept = due; kept != end; ++kept) {
    const double bound = std::max(static_cast<double>(kept->due) - front.moved, 0.0);
    waiting.push({static_cast<float>(bound * bound * (1.0 - kUlp)), kept->a, kept->b});
  }
  front.size = static_cast<std::uint32_t>(due - begin);
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
  const auto due = static_cast<float>((std::sqrt(squared_bound) + front.moved) * (1.0 - kUlp));
  if (due < front.cover && front.size == MeshFront::kCapacity) {
    makeRoom(front);
  }
  if (due < front.cover) {
    front.kept[front.size++] = {due, a, b};
  }
}

}  // namespace collision_monitor
