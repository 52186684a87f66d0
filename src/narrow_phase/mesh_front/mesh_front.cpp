// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/ball_motion.h"
#include "narrow_phase/mesh_front/front_entries.h"
#include "narrow_phase/mesh_front/front_lanes.h"

namespace collision_monitor {
namespace {

// The margin in steps, or as a share of the distance if that is more.
constexpr double kSteps = 32.0;
constexpr double kShare = 0.05;

// [m] Pairs farther away are not kept: empty slots are not much farther.
constexpr double kKeptWithin = 1e14;

// [m] After a longer step nothing that was kept is worth a look.
constexpr double kLongestStep = 1e3;

constexpr double kUlp = std::numeric_limits<float>::epsilon();
constexpr std::uint32_t kMask = (1U << kPackedBits) - 1;
constexpr std::uint32_t kChildBits = 8;
constexpr std::uint32_t kChildMask = (1U << kChildBits) - 1;

// Units of a radius in one unit of a coordinate.
constexpr double kFiner = 1 << 11;

double unitOf(const MeshTree& mesh) noexcept {
  constexpr double kSmallest = 1e-6;  // [m] gives a point a unit
  return std::max(mesh.radius(), kSmallest) / (kPackedMiddle - 1);
}

// @param units from 1 - kPackedMiddle to kPackedMiddle - 1, rounded to the nearest.
std::uint32_t numbersOf(const Eigen::Vector3d& units) noexcept {
  std::uint32_t bits = 0;
  for (const double x : units) {
    bits = (bits << kPackedBits) + static_cast<std::uint32_t>(x + (kPackedMiddle + 0.5));
  }
  return bits;
}

// Keeps the ball about a bound. The radius grows by the rounding of the center.
void keepBall(std::uint32_t at, const MovingBounds& moving, Slot slot, MeshFront& front) noexcept {
  constexpr double kMost = kPackedMiddle - 1;
  const MeshTreeNode& node = moving.tree->nodes()[slot >> kSlotBits];
  const std::uint32_t child = slot & (MeshTreeNode::kWidth - 1);
  Eigen::Vector3d center;
  Eigen::Vector3d half;
  for (int axis = 0; axis < 3; ++axis) {
    center[axis] = static_cast<double>(node.center[axis][child]);
    half[axis] = static_cast<double>(node.half[axis][child]);
  }
  center *= moving.units_per_metre;
  const std::uint32_t packed_center = numbersOf(center.cwiseMax(-kMost).cwiseMin(kMost));
  const double radius =
      half.norm() * moving.units_per_metre + (directionOf(packed_center) - center).norm();
  blockOf(at, front).center[placeOf(at)] = packed_center;
  blockOf(at, front).extent[placeOf(at)] =
      static_cast<std::uint32_t>(kFiner * (1.0 + kUlp) * radius + 1.0) << kChildBits;
}

// Keeps the nearer half of the pairs.
void makeRoom(MeshFront& front) noexcept {
  if (front.size == 0) {
    return;
  }
  std::array<float, MeshFront::kCapacity> sorted{};
  for (std::uint32_t i = 0; i < front.size; ++i) {
    sorted[i] = blockOf(i, front).bound[placeOf(i)];
  }
  const auto middle = sorted.begin() + front.size / 2;
  std::nth_element(sorted.begin(), middle, sorted.begin() + front.size);
  front.cover = std::min(front.cover, static_cast<double>(*middle));
  for (std::uint32_t i = 0; i < front.size;) {
    if (blockOf(i, front).bound[placeOf(i)] < *middle) {
      ++i;
    } else {
      drop(i, front);
    }
  }
}

float roundedDown(double bound) noexcept {
  return static_cast<float>(bound - kUlp * std::abs(bound));
}

FrontStep stepOf(const FollowedPair& pair, const Pose& before, double motion) noexcept {
  const Eigen::Vector3d center = pair.moving.center();
  const Eigen::Matrix3d turn = pair.resting_from_moving.rotation - before.rotation;
  const Eigen::Vector3d shift = pair.resting_from_moving * center - before * center;
  constexpr double kRounding = 64.0 * kUlp;  // of single precision, in a dozen sums of motions
  FrontStep step{};
  Eigen::Map<Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(&step.turn[0][0]) =
      (pair.side * turn).cast<float>();
  Eigen::Map<Eigen::Vector3f>(step.shift) = (pair.side * shift).cast<float>();
  step.size = static_cast<float>(std::sqrt(0.5 * turn.squaredNorm()));
  step.center_unit = static_cast<float>(unitOf(pair.moving));
  step.radius_unit = static_cast<float>(unitOf(pair.moving) / kFiner);
  step.slack = static_cast<float>((kRounding * motion + pair.rounding) * (1.0 + kUlp));
  return step;
}

}  // namespace

MovingBounds movingBounds(const MeshTree& tree, bool is_a) noexcept {
  return {&tree, is_a, 1.0 / unitOf(tree)};
}

float roundedUp(double goal) noexcept { return static_cast<float>(goal + kUlp * std::abs(goal)); }

void renew(std::uint32_t at, const FrontEntry& entry, MeshFront& front) noexcept {
  MeshFront::Block& block = blockOf(at, front);
  const std::size_t place = placeOf(at);
  block.bound[place] = roundedDown(entry.bound);
  block.direction[place] = entry.direction;
  block.extent[place] = (block.extent[place] & ~kChildMask) | entry.children;
}

FrontEntry entryAt(std::uint32_t at, const MeshFront& front) noexcept {
  const MeshFront::Block& block = blockOf(at, front);
  const std::size_t place = placeOf(at);
  return {block.kept[place], static_cast<double>(block.bound[place]), block.direction[place],
          block.extent[place] & kChildMask};
}

void drop(std::uint32_t at, MeshFront& front) noexcept {
  const std::uint32_t last = --front.size;
  const MeshFront::Block& from = blockOf(last, front);
  MeshFront::Block& to = blockOf(at, front);
  const std::size_t place = placeOf(at);
  to.bound[place] = from.bound[placeOf(last)];
  to.direction[place] = from.direction[placeOf(last)];
  to.center[place] = from.center[placeOf(last)];
  to.extent[place] = from.extent[placeOf(last)];
  to.kept[place] = from.kept[placeOf(last)];
}

bool ensureRoom(MeshFront& front) noexcept {
  return front.size < front.block_count * MeshFront::kBlockSize || front.pool.grow(front);
}

std::uint32_t packed(const Eigen::Vector3d& direction) noexcept {
  constexpr double kShortest = 1e-100;  // squares of shorter ones lose digits
  const double length = direction.norm();
  return length > kShortest && std::isfinite(length)
             ? numbersOf((kPackedMiddle - 1) / length * direction)
             : 0;
}

Eigen::Vector3d directionOf(std::uint32_t packed) noexcept {
  const auto at = [&](std::int32_t axis) {
    return static_cast<double>(packed >> (axis * kPackedBits) & kMask) - kPackedMiddle;
  };
  return {at(2), at(1), at(0)};
}

double follow(const FollowedPair& pair, MeshFront& front) noexcept {
  front.pool.touch(front);
  double step = std::numeric_limits<double>::infinity();
  if (front.resting_from_moving) {
    const Pose& before = *front.resting_from_moving;
    const double of_moving =
        motionOfBall(pair.moving.center(), pair.moving.radius(), before, pair.resting_from_moving);
    const double of_resting = motionOfBall(pair.center_of_resting, pair.radius_of_resting,
                                           inverse(before), inverse(pair.resting_from_moving));
    step = std::min(of_moving, of_resting) + pair.rounding;
    if (isSame(before, pair.resting_from_moving)) {
      return 0.0;
    }
    if (of_moving < kLongestStep) {
      loosen(stepOf(pair, before, of_moving), front);
    } else {
      front.cover = -std::numeric_limits<double>::infinity();  // then no bound is read
    }
  }
  front.resting_from_moving = pair.resting_from_moving;
  front.cover -= step;
  return step;
}

bool covers(double squared_goal, const MeshFront& front) noexcept {
  const double goal = std::sqrt(squared_goal);
  if (!(goal <= front.cover)) {
    return false;
  }
  return !front.is_whole || countBelow(roundedUp(goal), front) <= front.from_roots;
}

void restart(MeshFront& front) noexcept {
  front.pool.clear(front);
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

void keep(const FrontEntry& entry, const MovingBounds& moving, MeshFront& front) noexcept {
  if (!(entry.bound < front.cover)) {
    return;
  }
  if (!ensureRoom(front)) {
    makeRoom(front);
  }
  if (!ensureRoom(front)) {
    front.cover = entry.bound;  // there is no room at all
  } else if (entry.bound < front.cover) {
    const std::uint32_t at = front.size++;
    blockOf(at, front).kept[placeOf(at)] = entry.pair;
    keepBall(at, moving, moving.is_a ? entry.pair.a : entry.pair.b, front);
    renew(at, entry, front);
  }
}

}  // namespace collision_monitor
