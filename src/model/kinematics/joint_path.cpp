// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/kinematics/joint_path.h"

#include <algorithm>
#include <cmath>

namespace collision_monitor {
namespace {

/// start + share * (first + share * (second + share * third)).
struct Cubic {
  double start;
  double first;
  double second;
  double third;

  double at(double share) const noexcept {
    return start + share * (first + share * (second + share * third));
  }

  /// The largest distance from the chord of any piece of this length within two shares.
  double bendWithin(double from, double to, double length) const noexcept {
    const double most = std::max(std::abs(2.0 * second + 6.0 * third * from),
                                 std::abs(2.0 * second + 6.0 * third * to));
    return 0.125 * length * length * most;
  }
};

Cubic cubicOf(const JointPath& path, std::size_t segment, std::size_t joint) noexcept {
  const double start = path.positionAt(segment, joint);
  const double rise = path.positionAt(segment + 1, joint) - start;
  if (path.velocities.empty()) {
    return {start, rise, 0.0, 0.0};
  }
  const double duration = path.times[segment + 1] - path.times[segment];
  const double before = duration * path.velocities[segment * path.joints.size() + joint];
  const double after = duration * path.velocities[(segment + 1) * path.joints.size() + joint];
  return {start, before, 3.0 * rise - 2.0 * before - after, before + after - 2.0 * rise};
}

/// Shares at which the velocity is 0, in ascending order. Clamped to [`from`, `to`]; both ends if
/// there is none.
struct Turns {
  double first;
  double second;
};

Turns turnsWithin(const Cubic& cubic, double from, double to) noexcept {
  // first + 2 second s + 3 third s^2 = 0, solved by the form without cancellation.
  const double root = cubic.second * cubic.second - 3.0 * cubic.third * cubic.first;
  if (!(root > 0.0)) {
    return {from, to};
  }
  const double sum = -(cubic.second + std::copysign(std::sqrt(root), cubic.second));
  const double one = sum / (3.0 * cubic.third);
  const double other = cubic.first / sum;
  const auto within = [&](double share) {
    return std::isfinite(share) ? std::clamp(share, from, to) : to;
  };
  return {std::min(within(one), within(other)), std::max(within(one), within(other))};
}

bool allFinite(const std::vector<double>& values) noexcept {
  return std::all_of(values.begin(), values.end(),
                     [](double value) { return std::isfinite(value); });
}

}  // namespace

bool isSound(const JointPath& path) noexcept {
  const std::size_t size = path.times.size() * path.joints.size();
  const bool is_increasing =
      std::adjacent_find(path.times.begin(), path.times.end(),
                         [](double one, double next) { return !(one < next); }) == path.times.end();
  return !path.times.empty() && path.positions.size() == size &&
         (path.velocities.empty() || path.velocities.size() == size) && allFinite(path.times) &&
         allFinite(path.positions) && allFinite(path.velocities) && is_increasing;
}

double timeAt(const JointPath& path, std::size_t segment, double share) noexcept {
  const double start = path.times[segment];
  const double end = segment + 1 < path.times.size() ? path.times[segment + 1] : start;
  return share < 1.0 ? start + share * (end - start) : end;
}

void setPositions(const RobotModel& model, const JointPath& path, std::size_t segment, double share,
                  JointPositions& positions) noexcept {
  for (std::size_t i = 0; i < path.joints.size(); ++i) {
    double& position = positions[model.joint(path.joints[i]).first_variable];
    const bool is_last = segment + 1 == path.times.size();
    if (is_last || share == 0.0) {
      position = path.positionAt(segment, i);
    } else {
      position =
          share == 1.0 ? path.positionAt(segment + 1, i) : cubicOf(path, segment, i).at(share);
    }
  }
}

double travelOf(const JointPath& path, const PathPart& part, std::size_t joint) noexcept {
  const Cubic cubic = cubicOf(path, part.segment, joint);
  const Turns turns = turnsWithin(cubic, part.from, part.to);
  const double a = cubic.at(part.from);
  const double b = cubic.at(turns.first);
  const double c = cubic.at(turns.second);
  const double d = cubic.at(part.to);
  return std::abs(b - a) + std::abs(c - b) + std::abs(d - c);
}

JointStep stepOf(const JointPath& path, const PathPart& part, std::size_t joint) noexcept {
  const Cubic cubic = cubicOf(path, part.segment, joint);
  const double begin = cubic.at(part.from);
  const double middle = cubic.at(0.5 * (part.from + part.to));
  const double end = cubic.at(part.to);
  const double half = 0.5 * (end - begin);
  const double share = 0.5 * (part.to - part.from);
  return {half, std::abs(middle - begin - half) + cubic.bendWithin(part.from, part.to, share)};
}

JointStep stepOf(const JointPath& path, std::size_t first, std::size_t middle, std::size_t last,
                 std::size_t joint) noexcept {
  const double slope = (path.positionAt(last, joint) - path.positionAt(first, joint)) /
                       static_cast<double>(last - first);
  const double center = path.positionAt(middle, joint);
  double off = 0.0;
  double bend = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    const double after = static_cast<double>(i) - static_cast<double>(middle);
    off = std::max(off, std::abs(path.positionAt(i, joint) - center - after * slope));
    bend = std::max(bend, i == last ? 0.0 : cubicOf(path, i, joint).bendWithin(0.0, 1.0, 1.0));
  }
  return {slope * static_cast<double>(std::max(middle - first, last - middle)), off + bend};
}

}  // namespace collision_monitor
