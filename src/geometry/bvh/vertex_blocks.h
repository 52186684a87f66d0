// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// Vertices in blocks of blocks: those that lie far behind along a direction are passed over
/// together. For the many directions that a hull is asked about while it is made.
class VertexBlocks {
 public:
  /// @pre there is one at least, and all are finite.
  explicit VertexBlocks(const std::vector<Eigen::Vector3d>& vertices);

  /// The vertex of the greatest product with the direction, the first one if there are several: to
  /// the last bit what a look at all of them tells.
  /// @param likely a vertex that may be it, or near
  std::uint32_t farthest(const Eigen::Vector3d& direction, std::uint32_t likely) const noexcept;

 private:
  /// Holds the vertices of order_ in [first, last). Its children stand behind it, up to `next`.
  struct Block {
    Eigen::Vector3d center;
    double radius;  ///< of a ball about all that it holds, rounding of products included
    std::size_t first;
    std::size_t last;
    std::size_t next;
  };

  void add(std::size_t first, std::size_t last);
  std::size_t halve(std::size_t first, std::size_t last, const Eigen::Vector3d& size);

  const std::vector<Eigen::Vector3d>& vertices_;
  std::vector<std::uint32_t> order_;
  std::vector<Block> blocks_;  ///< a binary tree, parents first
  double rounding_;            ///< [m] of a product with a unit direction, at most
};

}  // namespace collision_monitor
