// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// The corners of the parts of a mesh, so that a search finds the one that is farthest in a
/// direction without opening the tree. A part is what a node of a MeshTree holds. The corners of a
/// node and of all nodes below it stand in one row.
///
/// Frames: as the nodes. Units: metres, in single precision.
class PartCorners {
 public:
  /// Ranges are multiples of this, for aligned vectors. The last corner repeats to fill them.
  static constexpr std::size_t kStep = 16;
  /// Nodes with fewer triangles are no parts: to open them costs less.
  static constexpr std::uint32_t kFewTriangles = 16;
  /// Nodes with more corners are no parts: to look at all of them costs more.
  static constexpr std::uint32_t kMostCorners = 2048;

  /// Corners [first, last).
  struct Range {
    std::uint32_t first{0};  ///< a multiple of kStep
    std::uint32_t last{0};   ///< beyond the last one; likewise

    bool empty() const noexcept { return first == last; }  ///< true if a node is no part
  };

  /// The range of a node, by its index.
  Range of(std::uint32_t node) const noexcept { return ranges_[node]; }
  /// Coordinates along an axis from corner `at` on, up to the next multiple of kStep. There they
  /// are aligned to 64 bytes.
  const float* along(std::size_t axis, std::uint32_t at) const noexcept {
    return &columns_[axis][at / kStep].at[at % kStep];
  }

 private:
  friend class PartCornersBuilder;

  struct alignas(64) Block {
    std::array<float, kStep> at;
  };

  std::vector<Range> ranges_;
  std::array<std::vector<Block>, 3> columns_;
};

}  // namespace collision_monitor
