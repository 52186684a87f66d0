// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// Finds vertices by their coordinates. 0 and -0 are equal. @pre no coordinate is NaN.
class VertexTable {
 public:
  /// Makes room for `count` different vertices. @pre firstEqual was not called before.
  void reserve(std::size_t count);

  /// The number of the first vertex that equals `vertex` among those already looked for; `own` if
  /// there is none.
  /// @param vertices a list that may grow at its end. It holds `vertex` at `own`, or will do so
  /// before the next call.
  std::uint32_t firstEqual(const Eigen::Vector3d& vertex, std::uint32_t own,
                           const std::vector<Eigen::Vector3d>& vertices);

 private:
  void growTo(std::size_t size, const std::vector<Eigen::Vector3d>& vertices);

  std::vector<std::uint32_t> slots_;  ///< numbers of vertices, each near the place of its hash
  std::size_t count_{0};
};

/// By vertex: the first vertex that equals it.
std::vector<std::uint32_t> firstEquals(const std::vector<Eigen::Vector3d>& vertices);

}  // namespace collision_monitor
