// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/bvh/split_triangles.h"

#include <algorithm>
#include <array>

namespace collision_monitor {
namespace {

constexpr std::size_t kBinCount = 16;

using Bins = std::array<SplitRange, kBinCount>;

void include(const SplitRange& from, SplitRange& to) noexcept {
  to.count += from.count;
  to.box.include(from.box);
  to.centers.include(from.centers);
}

void include(const SplitItem& item, SplitRange& to) noexcept {
  ++to.count;
  to.box.include(item.box);
  to.centers.include(item.doubledCenter());
}

// Sorts centers into bins.
struct Binning {
  Eigen::Index axis;
  float low;
  float bins_per_length;

  std::size_t binOf(const SplitItem& item) const noexcept {
    const float position = item.box.low[axis] + item.box.high[axis];
    // Converts to a signed number first: processors do that in one instruction.
    const auto bin = static_cast<std::int32_t>((position - low) * bins_per_length);
    return std::min(static_cast<std::size_t>(bin), kBinCount - 1);
  }
};

// The first bin of the upper part, where the sum of area times count is least. 0: no plane divides.
std::size_t cheapestCut(const Bins& bins) noexcept {
  std::array<float, kBinCount> upper_cost{};
  SplitRange side;
  for (std::size_t i = kBinCount; i-- > 1;) {
    include(bins[i], side);
    upper_cost[i] = side.count == 0 ? -1.0F : side.box.area() * static_cast<float>(side.count);
  }
  side = SplitRange{};
  std::size_t cheapest = 0;
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = 1; i < kBinCount; ++i) {
    include(bins[i - 1], side);
    const float cost = side.box.area() * static_cast<float>(side.count) + upper_cost[i];
    if (side.count > 0 && upper_cost[i] >= 0.0F && cost < least) {
      least = cost;
      cheapest = i;
    }
  }
  return cheapest;
}

void splitInHalves(SplitItem* items, const SplitRange& range, Eigen::Index axis, SplitRange& lower,
                   SplitRange& upper) noexcept {
  SplitItem* first = items + range.first;
  const std::uint32_t half = range.count / 2;
  std::nth_element(first, first + half, first + range.count,
                   [axis](const SplitItem& a, const SplitItem& b) {
                     return a.doubledCenter()[axis] < b.doubledCenter()[axis];
                   });
  lower = makeRange(items, range.first, half);
  upper = makeRange(items, range.first + half, range.count - half);
}

}  // namespace

float RoughBox::area() const noexcept {
  const Array4 size = (high - low).max(0.0F);
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

SplitRange makeRange(const SplitItem* items, std::uint32_t first, std::uint32_t count) noexcept {
  SplitRange range;
  std::for_each(items + first, items + first + count,
                [&range](const SplitItem& item) { include(item, range); });
  range.first = first;
  return range;
}

void splitRange(SplitItem* items, const SplitRange& range, bool by_count, SplitRange& lower,
                SplitRange& upper) noexcept {
  Eigen::Index axis = 0;
  const Eigen::Array3f spread = (range.centers.high - range.centers.low).head<3>();
  const float longest = spread.maxCoeff(&axis);
  if (by_count || !(longest > std::numeric_limits<float>::min())) {
    splitInHalves(items, range, axis, lower, upper);
    return;
  }
  const Binning binning{axis, range.centers.low[axis], static_cast<float>(kBinCount) / longest};
  Bins bins;
  SplitItem* begin = items + range.first;
  SplitItem* end = begin + range.count;
  std::for_each(begin, end,
                [&](const SplitItem& item) { include(item, bins[binning.binOf(item)]); });
  const std::size_t cut = cheapestCut(bins);
  if (cut == 0) {
    splitInHalves(items, range, axis, lower, upper);
    return;
  }
  std::partition(begin, end, [&](const SplitItem& item) { return binning.binOf(item) < cut; });
  lower = SplitRange{};
  upper = SplitRange{};
  for (std::size_t i = 0; i < kBinCount; ++i) {
    include(bins[i], i < cut ? lower : upper);
  }
  lower.first = range.first;
  upper.first = range.first + lower.count;
}

}  // namespace collision_monitor
