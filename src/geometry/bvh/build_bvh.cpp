// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/bvh/build_bvh.h"

#include <algorithm>
#include <limits>

#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

using Triangle = TriangleBvh::Triangle;
using Node = TriangleBvh::Node;
using Vector = Eigen::Array4f;  // the fourth number is 0 and fills the register

constexpr int kBins = 12;
constexpr std::size_t kFewTriangles = 6;  // up to this many are halved, without the heuristic
constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

struct Box {
  Vector low{Vector::Constant(kFloatInfinity)};
  Vector high{Vector::Constant(-kFloatInfinity)};

  void add(const Box& other) {
    low = low.min(other.low);
    high = high.max(other.high);
  }
  float area() const {
    const Vector size = high - low;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

/// What is reordered while the hierarchy is built.
struct Item {
  Box box;
  std::uint32_t triangle;

  Vector middle() const { return box.low + box.high; }  // twice the center
};

/// The bounds of some triangles and of their centers.
struct Bounds {
  Box box;
  Box middles;
  std::size_t count{0};

  void add(const Item& item) {
    const Vector middle = item.middle();
    box.add(item.box);
    middles.add({middle, middle});
    ++count;
  }
  void add(const Bounds& other) {
    box.add(other.box);
    middles.add(other.middles);
    count += other.count;
  }
};

struct Range {
  std::size_t first{0};
  Bounds bounds;

  std::size_t count() const { return bounds.count; }
};

Item itemOf(const TriangleBvh::UnitFrame& frame, const Triangle& triangle, std::uint32_t index) {
  const Eigen::Array3d low = triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]);
  const Eigen::Array3d high = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
  Item item;
  item.triangle = index;
  item.box.low.setZero();
  item.box.high.setZero();
  item.box.low.head<3>() = ((low - frame.center.array()) / frame.scale).cast<float>() - kBvhPadding;
  item.box.high.head<3>() =
      ((high - frame.center.array()) / frame.scale).cast<float>() + kBvhPadding;
  return item;
}

class BvhBuilder {
 public:
  BvhBuilder(const TriangleBvh::UnitFrame& frame, const std::vector<Triangle>& triangles) {
    items_.reserve(triangles.size());
    for (const auto& triangle : triangles) {
      items_.push_back(itemOf(frame, triangle, static_cast<std::uint32_t>(items_.size())));
    }
    nodes_.reserve(triangles.size() / 2 + 1);
    build(rangeOf(0, items_.size()), 0);
  }

  std::vector<Node> takeNodes() { return std::move(nodes_); }
  const std::vector<Item>& items() const { return items_; }

 private:
  Range rangeOf(std::size_t first, std::size_t count) const {
    Range range{first, {}};
    for (std::size_t i = first; i < first + count; ++i) {
      range.bounds.add(items_[i]);
    }
    return range;
  }

  std::uint32_t build(const Range& all, std::size_t depth) {
    throwIfInterrupted();
    std::array<Range, 4> parts{all};
    std::size_t part_count = 1;
    while (part_count < 4) {
      // Divides the part that queries are most likely to enter in vain.
      const auto widest = std::max_element(
          parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(part_count),
          [&](const Range& a, const Range& b) { return worth(a, depth) < worth(b, depth); });
      if (widest->count() < 2) {
        break;
      }
      parts[part_count++] = splitOff(*widest, depth);
    }
    const auto id = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    for (std::size_t lane = 0; lane < 4; ++lane) {
      setLane(id, lane, lane < part_count ? parts[lane] : Range{}, depth);
    }
    return id;
  }

  static float worth(const Range& range, std::size_t depth) {
    const float size =
        depth < kSplitByArea ? range.bounds.box.area() : static_cast<float>(range.count());
    return range.count() < 2 ? -1.0f : size;
  }

  void setLane(std::uint32_t id, std::size_t lane, const Range& part, std::size_t depth) {
    std::uint32_t child = 0;
    if (part.count() == 1) {
      child = Node::kLeaf + static_cast<std::uint32_t>(part.first);
    } else if (part.count() > 1) {
      child = build(part, depth + 1);
    }
    Node& node = nodes_[id];
    node.child[lane] = child;
    const auto l = static_cast<Eigen::Index>(lane);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      node.low[k][l] = part.count() > 0 ? part.bounds.box.low[axis] : kFloatInfinity;
      node.high[k][l] = part.count() > 0 ? part.bounds.box.high[axis] : kFloatInfinity;
    }
  }

  /// Sorts the range into two parts, keeps the first and returns the second.
  Range splitOff(Range& range, std::size_t depth) {
    const Box& middles = range.bounds.middles;
    Eigen::Index axis = 0;
    const float width = (middles.high - middles.low).maxCoeff(&axis);
    Item* first = items_.data() + range.first;
    if (range.count() > kFewTriangles && depth < kSplitByArea && width > 0.0f) {
      const float low = middles.low[axis];
      const float scale = static_cast<float>(kBins) / width;
      const auto binOf = [&](const Item& item) {
        const float place = (item.middle()[axis] - low) * scale;
        return static_cast<std::size_t>(std::min(static_cast<int>(place), kBins - 1));
      };
      std::array<Bounds, kBins> bins;
      for (std::size_t i = 0; i < range.count(); ++i) {
        bins[binOf(first[i])].add(first[i]);
      }
      const std::size_t border = cheapestBorder(bins);
      std::partition(first, first + range.count(),
                     [&](const Item& item) { return binOf(item) < border; });
      Range second;
      range.bounds = {};
      for (std::size_t bin = 0; bin < kBins; ++bin) {
        (bin < border ? range : second).bounds.add(bins[bin]);
      }
      second.first = range.first + range.count();
      return second;
    }
    const std::size_t half = range.count() / 2;
    std::nth_element(first, first + half, first + range.count(), [&](const Item& a, const Item& b) {
      return a.middle()[axis] < b.middle()[axis];
    });
    Range second = rangeOf(range.first + half, range.count() - half);
    range = rangeOf(range.first, half);
    return second;
  }

  /// The first bin of the second part, by the surface area heuristic. Neither part is empty,
  /// because the first and the last bin hold the outermost centers.
  static std::size_t cheapestBorder(const std::array<Bounds, kBins>& bins) {
    const auto costOf = [](const Bounds& part) {
      return part.box.area() * static_cast<float>(part.count);
    };
    std::array<float, kBins> cost_above{};
    Bounds above;
    for (std::size_t bin = kBins - 1; bin > 0; --bin) {
      above.add(bins[bin]);
      cost_above[bin] = costOf(above);
    }
    Bounds below;
    float least = kFloatInfinity;
    std::size_t border = 1;
    for (std::size_t bin = 1; bin < kBins; ++bin) {
      below.add(bins[bin - 1]);
      const float cost = costOf(below) + cost_above[bin];
      if (cost < least) {
        least = cost;
        border = bin;
      }
    }
    return border;
  }

  std::vector<Item> items_;
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<Node> buildBvh(const TriangleBvh::UnitFrame& frame, std::vector<Triangle>& triangles) {
  BvhBuilder builder(frame, triangles);
  std::vector<Triangle> sorted;
  sorted.reserve(triangles.size());
  for (const auto& item : builder.items()) {
    sorted.push_back(triangles[item.triangle]);
  }
  triangles = std::move(sorted);
  return builder.takeNodes();
}

}  // namespace collision_monitor
