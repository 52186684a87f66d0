// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/contact/hull_patch.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

ContactPatch capOf(const Cylinder& cylinder, double height) noexcept {
  constexpr double kTurn = 6.28318530717958647692;
  ContactPatch patch;
  for (; patch.size < ContactPatch::kMaxCorners; ++patch.size) {
    const double angle =
        kTurn * static_cast<double>(patch.size) / static_cast<double>(ContactPatch::kMaxCorners);
    patch.corners[patch.size] = {cylinder.radius * std::cos(angle),
                                 cylinder.radius * std::sin(angle), height};
  }
  return patch;
}

ContactPatch sideOf(const Cylinder& cylinder, const Vector3d& across) noexcept {
  const Vector3d up(0.0, 0.0, cylinder.half_length);
  ContactPatch patch;
  patch.corners[0] = across - up;
  patch.corners[1] = across + up;
  patch.size = 2;
  return patch;
}

}  // namespace

ContactPatch extremePatch(const Cylinder& cylinder, const Pose& world_from_cylinder,
                          const Vector3d& direction, double flat_sine) noexcept {
  const Vector3d in_cylinder = world_from_cylinder.rotation.transpose() * direction;
  const double along = in_cylinder.z();
  const double sine = in_cylinder.head<2>().norm();
  const double height = signOf(along) * cylinder.half_length;
  const double scale = sine > 0.0 ? cylinder.radius / sine : 0.0;
  const Vector3d across(scale * in_cylinder.x(), scale * in_cylinder.y(), 0.0);
  ContactPatch patch;
  if (sine <= flat_sine && cylinder.radius > 0.0) {
    patch = capOf(cylinder, height);
  } else if (std::abs(along) <= flat_sine && cylinder.half_length > 0.0) {
    patch = sideOf(cylinder, across);
  } else {
    patch.corners[patch.size++] = across + height * Vector3d::UnitZ();
  }
  for (std::size_t i = 0; i < patch.size; ++i) {
    patch.corners[i] = world_from_cylinder * patch.corners[i];
  }
  return patch;
}

}  // namespace collision_monitor
