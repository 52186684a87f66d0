// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>

/// Divides a range of triangles in two: the inner loop of building a MeshTree.
namespace collision_monitor {

/// Three numbers, and a fourth that fills the register.
using Array4 = Eigen::Array4f;

/// A box that may be empty. It is in single precision, because it only decides how triangles are
/// grouped and proves nothing.
struct RoughBox {
  Array4 low{Array4::Constant(std::numeric_limits<float>::max())};
  Array4 high{Array4::Constant(-std::numeric_limits<float>::max())};

  void include(const RoughBox& other) noexcept {
    low = low.min(other.low);
    high = high.max(other.high);
  }
  void include(const Array4& point) noexcept {
    low = low.min(point);
    high = high.max(point);
  }
  /// Half the surface area; 0 if empty.
  float area() const noexcept;
};

struct SplitItem {
  RoughBox box;
  std::uint32_t triangle;

  Array4 doubledCenter() const noexcept { return box.low + box.high; }
};

/// A range of items, with what its next division needs.
struct SplitRange {
  std::uint32_t first{0};
  std::uint32_t count{0};
  RoughBox box;
  RoughBox centers;  ///< bounds of the items' doubled centers
};

SplitRange makeRange(const SplitItem* items, std::uint32_t first, std::uint32_t count) noexcept;

/// Reorders the items of `range` and divides it. The plane lies across the longest axis of the
/// centers, where the surface area heuristic is least. The range is halved instead when all centers
/// are equal or `by_count` is set.
/// @pre range.count >= 2. Neither part is empty.
void splitRange(SplitItem* items, const SplitRange& range, bool by_count, SplitRange& lower,
                SplitRange& upper) noexcept;

}  // namespace collision_monitor
