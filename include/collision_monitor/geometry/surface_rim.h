// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace collision_monitor {

/// The sides of triangles at which a surface ends, in columns for the lanes of vectors.
///
/// A side runs as in its triangle. Units: metres.
class SurfaceRim {
 public:
  static constexpr std::size_t kLanes = 8;  ///< sides of a block

  /// Coordinates by column and side: three of the side's start, three of its end. Where a side is
  /// missing, start and end are equal.
  struct Block {
    alignas(64) std::array<std::array<double, kLanes>, 6> columns;  ///< [m]
  };

  /// Sums over the sides of a lane.
  struct Sums {
    alignas(64) std::array<double, kLanes> gradients;        ///< [1/m] of length / r^2
    alignas(64) std::array<double, kLanes> squared_nearest;  ///< [m^2] the least
  };

  void add(const Eigen::Vector3d& from, const Eigen::Vector3d& to);  ///< adds a side

  std::size_t size() const noexcept { return size_; }                    ///< number of sides
  const std::vector<Block>& blocks() const noexcept { return blocks_; }  ///< all sides

 private:
  std::vector<Block> blocks_;
  std::size_t size_{0};
};

/// The walls that go on from a rim, seen from a point.
struct RimWalls {
  double angle{0.0};  ///< [sr] the sum of their solid angles
  /// The point is not in a wall. Else `angle` may lack whole turns of 4 pi.
  bool is_certain{false};
};

/// From each side a wall goes on without end. The walls close the surface: seen from a point, its
/// solid angle less that of the walls is a whole number of turns of 4 pi.
///
/// Frames: those of the rim. Error: about 1e-9 sr.
/// Source: SolidAngles, with the third corner at infinity.
/// @param direction where the walls go; a unit vector
RimWalls wallsSeenFrom(const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                       const SurfaceRim& rim) noexcept;

/// What the rim of a surface does to winding numbers near a point. Off the surface their gradient
/// is the sum of dl / (4 pi r^2) over the rim, by Biot and Savart.
struct RimAtPoint {
  double gradient{0.0};                                     ///< [1/m] an upper bound at the point
  double nearest{std::numeric_limits<double>::infinity()};  ///< [m] at most the rim's distance

  void add(double length, double distance) noexcept;  ///< a piece of the rim, no nearer than this
};

RimAtPoint rimAt(const Eigen::Vector3d& point, const SurfaceRim& rim) noexcept;  ///< of all sides

}  // namespace collision_monitor
