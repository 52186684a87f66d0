// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "exercise.h"

#include <cmath>
#include <cstdio>

#include "fitting/search/point_cloud.h"
#include "narrow_phase/distance.h"

namespace collision_monitor::two_capsules {
namespace {

constexpr std::size_t kClicksEach = 3;
constexpr std::size_t kClicks = 2 * kClicksEach;
constexpr double kFarthest = 1000.0;
constexpr double kLeastRadius = 0.001;
/// Smaller values print as 0 with three decimals.
constexpr double kTouching = 0.0005;

std::string refusalOf(const Eigen::Vector3d& point, const Exercise& exercise) {
  const Points& clicks = exercise.clicks;
  if (clicks.size() == kClicks) {
    return "refused: both capsules stand";
  }
  // Comparisons with NaN are false.
  if (!(point.array().abs() <= kFarthest).all()) {
    return "refused: a click must be finite and within 1000 m";
  }
  if (clicks.size() % kClicksEach == 1 && (point - clicks.back()).norm() < kLeastRadius) {
    return "refused: the rim must be 1 mm or more from the end";
  }
  return "";
}

PosedShape placeCapsule(const Eigen::Vector3d& end, double radius,
                        const Eigen::Vector3d& other_end) {
  const Eigen::Vector3d way = other_end - end;
  const double length = way.stableNorm();
  const Eigen::Vector3d axis =
      length > 0.0 ? way.stableNormalized() : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  return {Capsule{0.5 * length, radius}, {rotationWithAxis(axis), end + 0.5 * way}};
}

}  // namespace

void takeClick(const Eigen::Vector3d& point, Exercise& exercise) {
  exercise.refusal = refusalOf(point, exercise);
  if (exercise.refusal.empty()) {
    exercise.clicks.push_back(point);
  }
}

std::vector<PosedShape> capsulesOf(const Exercise& exercise) {
  const Points& clicks = exercise.clicks;
  std::vector<PosedShape> capsules;
  for (std::size_t first = 0; first + 1 < clicks.size(); first += kClicksEach) {
    const Eigen::Vector3d& end = clicks[first];
    const bool is_whole = first + 2 < clicks.size();
    capsules.push_back(
        placeCapsule(end, (clicks[first + 1] - end).norm(), is_whole ? clicks[first + 2] : end));
  }
  return capsules;
}

std::optional<SignedDistance> distanceOf(const Exercise& exercise) {
  if (exercise.clicks.size() < kClicks) {
    return std::nullopt;
  }
  const std::vector<PosedShape> capsules = capsulesOf(exercise);
  return distanceBetween(capsules[0].shape, capsules[0].geometry_from_body, capsules[1].shape,
                         capsules[1].geometry_from_body);
}

std::string distanceText(double distance) {
  if (std::abs(distance) < kTouching) {
    return "touching";
  }
  char text[32];
  std::snprintf(text, sizeof text, "%s%.3f m", distance < 0.0 ? "overlap " : "",
                std::abs(distance));
  return text;
}

std::string promptOf(const Exercise& exercise) {
  static constexpr const char* kWanted[kClicksEach] = {
      "click one end", "click a point on the rim, which sets the radius", "click the other end"};
  const std::size_t count = exercise.clicks.size();
  const std::string next = count == kClicks ? "press R in the terminal to start again"
                                            : "capsule " + std::to_string(1 + count / kClicksEach) +
                                                  ": " + kWanted[count % kClicksEach];
  return exercise.refusal.empty() ? next : exercise.refusal + "\n" + next;
}

}  // namespace collision_monitor::two_capsules
