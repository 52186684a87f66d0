// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/ball_motion.h"

namespace collision_monitor {
namespace {

// The margin: steps, or the share of the distance if that is more.
constexpr double kSteps = 32.0;
constexpr double kShare = 0.05;

// [m] What is farther is not kept, for bounds of empty slots are not much farther.
constexpr double kKeptWithin = 1e14;

// [m] Beyond this, sums in single precision lose what they are kept for.
constexpr double kLongest = 1.0;

constexpr double kUlp = std::numeric_limits<float>::epsilon();

// Directions are kept as three numbers of so many bits.
constexpr std::uint32_t kBits = 10;
constexpr std::uint32_t kMiddle = 1U << (kBits - 1);
constexpr std::uint32_t kMask = (1U << kBits) - 1;

// Leaves half of the room to those that are nearest.
void makeRoom(MeshFront& front) noexcept {
  std::array<float, MeshFront::kCapacity> sorted = front.due;
  const auto middle = sorted.begin() + MeshFront::kCapacity / 2;
  std::nth_element(sorted.begin(), middle, sorted.end());
  front.cover = std::min(front.cover, static_cast<double>(*middle));
  std::uint32_t size = 0;
  for (std::uint32_t i = 0; i < front.size; ++i) {
    if (front.due[i] < *middle) {
      front.due[size] = front.due[i];
      front.kept[size++] = front.kept[i];
    }
  }
  front.size = size;
}

// Dues less what was moved, from where they are counted anew.
void countAnew(MeshFront& front) noexcept {
  for (std::uint32_t i = 0; i < front.size; ++i) {
    const double due = static_cast<double>(front.due[i]) - front.moved;
    front.due[i] = static_cast<float>(due - kUlp * std::abs(due));
  }
  front.cover -= front.moved;
  front.moved = 0.0;
}

}  // namespace

float boundDue(float due, const MeshFront& front) noexcept {
  const double bound = std::max(static_cast<double>(due) - front.moved, 0.0);
  return static_cast<float>(bound * bound * (1.0 - kUlp));
}

float dueOf(double squared_bound, const MeshFront& front) noexcept {
  return static_cast<float>((std::sqrt(squared_bound) + front.moved) * (1.0 - kUlp));
}

void drop(std::uint32_t at, MeshFront& front) noexcept {
  --front.size;
  front.due[at] = front.due[front.size];
  front.kept[at] = front.kept[front.size];
}

std::uint32_t packed(const Eigen::Vector3d& direction) noexcept {
  const double longest = direction.cwiseAbs().maxCoeff();
  if (!(longest > 0.0) || !direction.allFinite()) {
    return 0;
  }
  std::uint32_t bits = 0;
  for (const double x : direction) {
    const double share = x / longest * (kMiddle - 1) + kMiddle;
    bits = (bits << kBits) + static_cast<std::uint32_t>(std::lround(share));
  }
  return bits;
}

Eigen::Vector3d directionOf(std::uint32_t packed) noexcept {
  const auto at = [&](std::uint32_t axis) {
    return static_cast<double>(packed >> (axis * kBits) & kMask) - kMiddle;
  };
  return {at(2), at(1), at(0)};
}

double follow(const FollowedPair& pair, MeshFront& front) noexcept {
  double step = std::numeric_limits<double>::infinity();
  if (front.a_from_b) {
    const double of_b =
        motionOfBall(pair.center_of_b, pair.radius_of_b, *front.a_from_b, pair.a_from_b);
    const double of_a = motionOfBall(pair.center_of_a, pair.radius_of_a, inverse(*front.a_from_b),
                                     inverse(pair.a_from_b));
    step = std::min(of_a, of_b) + pair.rounding;
  }
  front.a_from_b = pair.a_from_b;
  front.moved += step;
  if (front.moved > kLongest && std::isfinite(front.moved)) {
    countAnew(front);
  }
  return step;
}

float dueNow(double squared_goal, const MeshFront& front) noexcept {
  return static_cast<float>((std::sqrt(squared_goal) + front.moved) * (1.0 + kUlp));
}

bool covers(double squared_goal, const MeshFront& front) noexcept {
  if (!(std::sqrt(squared_goal) <= front.cover - front.moved)) {
    return false;
  }
  const auto end = front.due.begin() + front.size;
  const float now = dueNow(squared_goal, front);
  return !front.is_whole || std::count_if(front.due.begin(), end, [now](float due) {
                              return due < now;
                            }) <= static_cast<std::ptrdiff_t>(front.from_roots);
}

void restart(MeshFront& front) noexcept {
  front.size = 0;
  front.moved = 0.0;
  front.cover = kKeptWithin;
  front.from_roots = 0;
  front.is_whole = false;
}

void setMargin(double step, double squared_distance, MeshFront& front) noexcept {
  const double wanted = std::max(kSteps * step, kShare * std::sqrt(squared_distance));
  front.margin = std::isfinite(wanted) ? wanted : 0.0;
}

double squaredReach(double squared_distance, const MeshFront& front) noexcept {
  const double reach = std::sqrt(squared_distance) + front.margin;
  return std::max(reach * reach, squared_distance);
}

void keep(std::uint32_t a, std::uint32_t b, double squared_bound, std::uint32_t detail,
          MeshFront& front) noexcept {
  const float due = dueOf(squared_bound, front);
  if (due < front.cover && front.size == MeshFront::kCapacity) {
    makeRoom(front);
  }
  if (due < front.cover) {
    front.due[front.size] = due;
    front.kept[front.size++] = {a, b, detail};
  }
}

}  // namespace collision_monitor
