// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// Vertices in nested blocks, so that a search passes over whole blocks that lie far behind along
/// its direction. Serves the many support queries while a hull is built.
class VertexBlocks {
 public:
  /// @pre at least one vertex; all are finite.
  explicit VertexBlocks(const std::vector<Eigen::Vector3d>& vertices);

  /// The vertex with the greatest dot product with the direction, the first one of several. The
  /// result equals that of a search through all vertices to the last bit.
  /// @param likely a vertex that may be the answer, or is near it
  std::uint32_t farthest(const Eigen::Vector3d& direction, std::uint32_t likely) const noexcept;

 private:
  /// Holds the vertices of order_ in [first, last). Its children follow it, up to `next`.
  struct Block {
    Eigen::Vector3d center;
    double radius;  ///< of a ball about all its vertices, rounding of products included
    std::size_t first;
    std::size_t last;
    std::size_t next;
  };

  void add(std::size_t first, std::size_t last);
  std::size_t halve(std::size_t first, std::size_t last, const Eigen::Vector3d& size);

  const std::vector<Eigen::Vector3d>& vertices_;
  std::vector<std::uint32_t> order_;
  std::vector<Block> blocks_;  ///< a binary tree, parents first
  double rounding_;            ///< [m] greatest rounding error of a product with a unit direction
};

}  // namespace collision_monitor
