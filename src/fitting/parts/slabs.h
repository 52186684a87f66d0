// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "fitting/shapes/mesh_part.h"

namespace collision_monitor {

/// The columns of the frames, without axes that are nearly the same.
std::vector<Eigen::Vector3d> distinctAxes(const std::vector<Eigen::Matrix3d>& frames);

/// The surface of a part, divided into slabs across an axis. Cuts run between slabs.
class Slabs {
 public:
  static constexpr int kCount = 80;

  /// @param samples points of the surface, which outlive this.
  Slabs(const Points& samples, const Eigen::Vector3d& axis);

  /// False if the part has no extent along the axis.
  bool canBeCut() const noexcept { return thickness_ > 0.0; }
  /// @pre canBeCut().
  std::size_t slabOf(const Eigen::Vector3d& sample) const noexcept;
  /// The plane above the first `below` slabs.
  CutPlane plane(int below) const noexcept { return {axis_, low_ + below * thickness_}; }
  /// The farthest points of the slabs [first, last) in many directions, each once; none if these
  /// are empty.
  Points pointsOf(int first, int last) const;

 private:
  static constexpr int kDirections = 48;

  /// The farthest points of a slab in all directions.
  struct Extremes {
    std::array<double, kDirections> reach;
    std::array<std::uint32_t, kDirections> point{};

    Extremes() { reach.fill(-std::numeric_limits<double>::infinity()); }
    void add(const Extremes& other);
  };

  void add(std::uint32_t sample, Extremes& extremes) const;

  const Points* samples_;
  Eigen::Vector3d axis_;
  double low_{0.0};
  double thickness_{0.0};
  std::array<Extremes, kCount> slabs_;
};

}  // namespace collision_monitor
