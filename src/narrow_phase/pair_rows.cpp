// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/narrow_phase/pair_rows.h"

#include <Eigen/Geometry>
#include <cmath>

#include "collision_monitor/narrow_phase/distance.h"
#include "narrow_phase/core_distance.h"
#include "narrow_phase/finish_rows.h"

namespace collision_monitor {
namespace {

Eigen::Vector3d vectorAt(const ShapeRows& rows, std::size_t c, std::size_t row) noexcept {
  return {rows.at[c][row], rows.at[c + 1][row], rows.at[c + 2][row]};
}

void writeVector(const Eigen::Vector3d& v, std::size_t c, std::size_t row,
                 ShapeRows& rows) noexcept {
  rows.at[c][row] = v.x();
  rows.at[c + 1][row] = v.y();
  rows.at[c + 2][row] = v.z();
}

/// A shape read back for the plain twin. A segment's other axes may be any.
struct PosedShape {
  Shape shape;
  Pose pose;
};

PosedShape readShape(CoreKind kind, const ShapeRows& rows, std::size_t row) noexcept {
  PosedShape read;
  read.pose.translation = vectorAt(rows, column::center, row);
  const double radius = rows.at[column::radius][row];
  if (kind == CoreKind::point) {
    read.shape = Sphere{radius};
    return read;
  }
  const double half_z = rows.at[column::half_z][row];
  const Eigen::Vector3d z = vectorAt(rows, column::axis_z, row);
  if (kind == CoreKind::segment) {
    const Eigen::Vector3d x = perpendicularTo(z);
    read.pose.rotation << x, z.cross(x), z;
    read.shape = Capsule{half_z, radius};
    return read;
  }
  read.pose.rotation << vectorAt(rows, column::axis_x, row), vectorAt(rows, column::axis_y, row), z;
  read.shape =
      RoundedBox{{rows.at[column::half_x][row], rows.at[column::half_y][row], half_z}, radius};
  return read;
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

void finishRows(CoreKind a, CoreKind b, std::size_t count, PairRows& rows) noexcept {
  for (std::size_t row = 0; row < count; ++row) {
    if (std::isnan(rows.answers.at[answer::distance][row])) {
      const PosedShape on_a = readShape(a, rows.a, row);
      const PosedShape on_b = readShape(b, rows.b, row);
      if (isFinite(on_a.pose) && isFinite(on_b.pose)) {
        writeAnswer(distanceBetween(on_a.shape, on_a.pose, on_b.shape, on_b.pose), row, rows);
      }
    }
  }
}

SignedDistance readAnswer(const PairRows& rows, std::size_t row) noexcept {
  const auto& at = rows.answers.at;
  const auto vector = [&](std::size_t c) {
    return Eigen::Vector3d(at[c][row], at[c + 1][row], at[c + 2][row]);
  };
  return {at[answer::distance][row], vector(answer::point_on_a), vector(answer::point_on_b),
          vector(answer::normal)};
}

}  // namespace collision_monitor
