// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/build_bvh.h"

#include <algorithm>
#include <limits>

namespace collision_monitor {
namespace {

using Triangle = TriangleBvh::Triangle;
using Node = TriangleBvh::Node;
using Vector = Eigen::Array4f;  // the fourth is 0, and fills the register

constexpr int kBins = 12;
constexpr std::size_t kFewTriangles = 6;  // are halved: their boxes are not worth weighing
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Box {
  Vector low{Vector::Constant(kInfinity)};
  Vector high{Vector::Constant(-kInfinity)};

  void add(const Box& other) {
    low = low.min(other.low);
    high = high.max(other.high);
  }
  float area() const {
    const Vector size = high - low;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

/// What is moved about while the hierarchy is built.
struct Item {
  Box box;
  std::uint32_t triangle;

  Vector middle() const { return box.low + box.high; }  // twice
};

struct Range {
  std::size_t first;
  std::size_t count;
  Box box;
};

Item itemOf(const TriangleBvh::UnitFrame& frame, const Triangle& triangle, std::uint32_t index) {
  const Eigen::Array3d low = triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]);
  const Eigen::Array3d high = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
  Item item;
  item.triangle = index;
  item.box.low.setZero();
  item.box.high.setZero();
  item.box.low.head<3>() = ((low - frame.centre.array()) / frame.scale).cast<float>() - kBvhPadding;
  item.box.high.head<3>() =
      ((high - frame.centre.array()) / frame.scale).cast<float>() + kBvhPadding;
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
    Range range{first, count, {}};
    for (std::size_t i = first; i < first + count; ++i) {
      range.box.add(items_[i].box);
    }
    return range;
  }

  std::uint32_t build(const Range& all, std::size_t depth) {
    std::array<Range, 4> parts{all};
    std::size_t part_count = 1;
    while (part_count < 4) {
      // The part that a query is most likely to enter for nothing.
      const auto widest = std::max_element(
          parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(part_count),
          [&](const Range& a, const Range& b) { return worth(a, depth) < worth(b, depth); });
      if (widest->count < 2) {
        break;
      }
      const std::size_t lower = splitOff(*widest, depth);
      parts[part_count++] = rangeOf(widest->first + lower, widest->count - lower);
      *widest = rangeOf(widest->first, lower);
    }
    const auto id = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    for (std::size_t lane = 0; lane < 4; ++lane) {
      setLane(id, lane, lane < part_count ? parts[lane] : Range{0, 0, {}}, depth);
    }
    return id;
  }

  static float worth(const Range& range, std::size_t depth) {
    const float size = depth < kSplitByArea ? range.box.area() : static_cast<float>(range.count);
    return range.count < 2 ? -1.0f : size;
  }

  void setLane(std::uint32_t id, std::size_t lane, const Range& part, std::size_t depth) {
    std::uint32_t child = 0;
    if (part.count == 1) {
      child = Node::kLeaf + static_cast<std::uint32_t>(part.first);
    } else if (part.count > 1) {
      child = build(part, depth + 1);
    }
    Node& node = nodes_[id];
    node.child[lane] = child;
    const auto l = static_cast<Eigen::Index>(lane);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      node.low[k][l] = part.count > 0 ? part.box.low[axis] : kInfinity;
      node.high[k][l] = part.count > 0 ? part.box.high[axis] : kInfinity;
    }
  }

  /// Sorts the range into two parts and returns the size of the first.
  std::size_t splitOff(const Range& range, std::size_t depth) {
    Box middles;
    for (std::size_t i = range.first; i < range.first + range.count; ++i) {
      const Vector middle = items_[i].middle();
      middles.add({middle, middle});
    }
    Eigen::Index axis = 0;
    const float width = (middles.high - middles.low).maxCoeff(&axis);
    Item* first = items_.data() + range.first;
    if (range.count > kFewTriangles && depth < kSplitByArea && width > 0.0f) {
      const float scale = static_cast<float>(kBins) / width;
      const auto binOf = [&](const Item& item) {
        const float place = (item.middle()[axis] - middles.low[axis]) * scale;
        return std::min(static_cast<int>(place), kBins - 1);
      };
      const int border = cheapestBorder(first, range.count, binOf);
      const Item* second = std::partition(first, first + range.count,
                                          [&](const Item& item) { return binOf(item) < border; });
      return static_cast<std::size_t>(second - first);
    }
    std::nth_element(
        first, first + range.count / 2, first + range.count,
        [&](const Item& a, const Item& b) { return a.middle()[axis] < b.middle()[axis]; });
    return range.count / 2;
  }

  /// The first bin of the second part, by the surface area heuristic. Both parts get something:
  /// the first and the last bin hold the outermost middles.
  template <class BinOf>
  static int cheapestBorder(const Item* items, std::size_t count, const BinOf& binOf) {
    std::array<Box, kBins> boxes;
    std::array<float, kBins> counts{};
    for (std::size_t i = 0; i < count; ++i) {
      const auto bin = static_cast<std::size_t>(binOf(items[i]));
      boxes[bin].add(items[i].box);
      counts[bin] += 1.0f;
    }
    std::array<float, kBins> cost_above{};
    Box above;
    float count_above = 0.0f;
    for (std::size_t bin = kBins - 1; bin > 0; --bin) {
      above.add(boxes[bin]);
      count_above += counts[bin];
      cost_above[bin] = above.area() * count_above;
    }
    Box below;
    float count_below = 0.0f;
    float least = kInfinity;
    int border = 1;
    for (std::size_t bin = 1; bin < kBins; ++bin) {
      below.add(boxes[bin - 1]);
      count_below += counts[bin - 1];
      const float cost = below.area() * count_below + cost_above[bin];
      if (cost < least) {
        least = cost;
        border = static_cast<int>(bin);
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
