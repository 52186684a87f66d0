// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/narrow_phase/signed_distance.h"

/// Measures many pairs of one kind at once. Entry k of every column belongs to pair k, so a vector
/// register holds one column of as many pairs as it has lanes. distanceBetween of distance.h is the
/// plain twin of measureRows; docs/decisions/batched-kernels.md says how the two share the work.
namespace collision_monitor {

/// Number of pairs measured together: a multiple of the lane count of every instruction set.
constexpr std::size_t kRowCount = 64;

/// Columns of a posed shape. Frames: world. Units: [m]. A point fills the first four, a segment
/// (along its z axis) the first eight, a box all.
namespace column {
constexpr std::size_t center = 0;   ///< x, y, z
constexpr std::size_t radius = 3;   ///< around the core
constexpr std::size_t axis_z = 4;   ///< the body's z axis in the world: x, y, z
constexpr std::size_t half_z = 7;   ///< half length of a segment, half extent of a box along z
constexpr std::size_t axis_x = 8;   ///< the body's x axis in the world: x, y, z
constexpr std::size_t half_x = 11;  ///< half extent of a box along x
constexpr std::size_t axis_y = 12;  ///< the body's y axis in the world: x, y, z
constexpr std::size_t half_y = 15;  ///< half extent of a box along y
constexpr std::size_t count = 16;   ///< how many columns there are
}  // namespace column

/// Number of columns that a kind fills.
constexpr std::size_t columnCountOf(CoreKind kind) noexcept {
  return kind == CoreKind::point ? 4 : kind == CoreKind::segment ? 8 : column::count;
}

/// Columns of one number for each pair.
template <std::size_t kColumns>
struct Columns {
  alignas(64) std::array<std::array<double, kRowCount>, kColumns> at;  ///< by column, then by pair
};

using ShapeRows = Columns<column::count>;  ///< columns of posed shapes, as `column` names them

/// Columns of an answer, in the order of SignedDistance.
namespace answer {
constexpr std::size_t distance = 0;    ///< signed, [m]
constexpr std::size_t point_on_a = 1;  ///< x, y, z
constexpr std::size_t point_on_b = 4;  ///< x, y, z
constexpr std::size_t normal = 7;      ///< x, y, z: unit, from A to B
constexpr std::size_t count = 10;      ///< how many columns there are
}  // namespace answer

/// Not initialised: writeRow fills all that measureRows reads.
struct PairRows {
  ShapeRows a;                     ///< the first shape of each pair
  ShapeRows b;                     ///< the second shape of each pair
  Columns<answer::count> answers;  ///< what measureRows found, as `answer` names it
};

/// What a row needs of a shape, computed once per shape.
struct Core {
  CoreKind kind{CoreKind::point};  ///< of the shape
  /// [m] Along x, y, z; 0 where the core has none.
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};
  double radius{0.0};  ///< [m] around the core
};

Core coreOf(const Shape& shape) noexcept;  ///< the core of a shape

/// Writes a posed core into a row. @pre row < kRowCount
void writeRow(const Core& core, const Pose& world_from_body, std::size_t row,
              ShapeRows& rows) noexcept;

/// Measures signed distance, points and normal of the first `count` pairs. Each is a core of kind
/// `a` with one of kind `b`. See signed_distance.h for frames and sign.
///
/// Error: at most 1e-12 m, as distanceBetween, which takes the degenerate pairs (cores that touch,
/// parallel boxes, axes that tie). All instruction sets give the same bytes: they use the same
/// operations in the same order, and no fused multiply-add.
/// Limits: a pose that is not finite gives a distance of NaN.
/// Source: as distanceBetween, with selections in place of branches.
/// @pre a <= b in the order of CoreKind; count <= kRowCount.
void measureRows(CoreKind a, CoreKind b, std::size_t count, PairRows& rows) noexcept;

/// Reads the answer of a row. If `is_swapped`, exchanges A and B.
void readAnswer(const PairRows& rows, std::size_t row, bool is_swapped,
                SignedDistance& measured) noexcept;

}  // namespace collision_monitor
