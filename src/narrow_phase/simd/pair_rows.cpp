// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/narrow_phase/pair_rows.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/distance.h"
#include "narrow_phase/simd/plain_twin.h"

namespace collision_monitor {
namespace {

void writeVector(const Eigen::Vector3d& v, std::size_t c, std::size_t row,
                 ShapeRows& rows) noexcept {
  rows.at[c][row] = v.x();
  rows.at[c + 1][row] = v.y();
  rows.at[c + 2][row] = v.z();
}

Shape shapeOf(const Core& core) noexcept {
  switch (core.kind) {
    case CoreKind::point:
      return Sphere{core.radius};
    case CoreKind::segment:
      return Capsule{core.half_extents.z(), core.radius};
    case CoreKind::box:
      break;
  }
  return RoundedBox{core.half_extents, core.radius};
}

void writeAnswer(const SignedDistance& measured, std::size_t row, PairRows& rows) noexcept {
  auto& at = rows.answers.at;
  at[answer::distance][row] = measured.distance;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    at[answer::point_on_a + k][row] = measured.point_on_a[i];
    at[answer::point_on_b + k][row] = measured.point_on_b[i];
    at[answer::normal + k][row] = measured.normal_a_to_b[i];
  }
}

}  // namespace

Core coreOf(const Shape& shape) noexcept {
  return {coreKindOf(shape), coreHalfExtents(shape), radiusOf(shape)};
}

void writeRow(const Core& core, const Pose& world_from_body, std::size_t row,
              ShapeRows& rows) noexcept {
  const Eigen::Matrix3d& rotation = world_from_body.rotation;
  writeVector(world_from_body.translation, column::center, row, rows);
  rows.at[column::radius][row] = core.radius;
  if (core.kind == CoreKind::point) {
    return;
  }
  writeVector(rotation.col(2), column::axis_z, row, rows);
  rows.at[column::half_z][row] = core.half_extents.z();
  if (core.kind == CoreKind::segment) {
    return;
  }
  writeVector(rotation.col(0), column::axis_x, row, rows);
  rows.at[column::half_x][row] = core.half_extents.x();
  writeVector(rotation.col(1), column::axis_y, row, rows);
  rows.at[column::half_y][row] = core.half_extents.y();
}

PosedCore readCore(CoreKind kind, const double* first, std::size_t stride) noexcept {
  const auto vectorAt = [&](std::size_t c) {
    return Eigen::Vector3d(first[c * stride], first[(c + 1) * stride], first[(c + 2) * stride]);
  };
  PosedCore read;
  read.core = {kind, Eigen::Vector3d::Zero(), first[column::radius * stride]};
  read.pose.translation = vectorAt(column::center);
  if (kind != CoreKind::point) {
    read.core.half_extents.z() = first[column::half_z * stride];
  }
  if (kind == CoreKind::segment) {
    read.pose = poseAlong(vectorAt(column::axis_z), read.pose.translation);
  } else if (kind == CoreKind::box) {
    read.core.half_extents.x() = first[column::half_x * stride];
    read.core.half_extents.y() = first[column::half_y * stride];
    read.pose.rotation << vectorAt(column::axis_x), vectorAt(column::axis_y),
        vectorAt(column::axis_z);
  }
  return read;
}

Pose poseAlong(const Eigen::Vector3d& axis_z, const Eigen::Vector3d& translation) noexcept {
  const Eigen::Vector3d x = perpendicularTo(axis_z);
  Pose pose;
  pose.rotation << x, axis_z.cross(x), axis_z;
  pose.translation = translation;
  return pose;
}

SignedDistance plainDistance(const Core& a, const Pose& world_from_a, const Core& b,
                             const Pose& world_from_b) noexcept {
  if (!isFinite(world_from_a) || !isFinite(world_from_b)) {
    SignedDistance unknown;
    unknown.distance = std::numeric_limits<double>::quiet_NaN();
    return unknown;
  }
  return distanceBetween(shapeOf(a), world_from_a, shapeOf(b), world_from_b);
}

void finishRows(CoreKind a, CoreKind b, std::size_t count, PairRows& rows) noexcept {
  for (std::size_t row = 0; row < count; ++row) {
    if (std::isnan(rows.answers.at[answer::distance][row])) {
      const PosedCore on_a = readCore(a, &rows.a.at[0][row], kRowCount);
      const PosedCore on_b = readCore(b, &rows.b.at[0][row], kRowCount);
      writeAnswer(plainDistance(on_a.core, on_a.pose, on_b.core, on_b.pose), row, rows);
    }
  }
}

void readAnswer(const PairRows& rows, std::size_t row, bool is_swapped,
                SignedDistance& measured) noexcept {
  const auto& at = rows.answers.at;
  const std::size_t first = is_swapped ? answer::point_on_b : answer::point_on_a;
  const std::size_t second = is_swapped ? answer::point_on_a : answer::point_on_b;
  measured.distance = at[answer::distance][row];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const double normal = at[answer::normal + k][row];
    measured.point_on_a[i] = at[first + k][row];
    measured.point_on_b[i] = at[second + k][row];
    measured.normal_a_to_b[i] = is_swapped ? -normal : normal;
  }
}

}  // namespace collision_monitor
