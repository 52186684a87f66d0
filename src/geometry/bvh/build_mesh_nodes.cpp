// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/bvh/build_mesh_nodes.h"

#include <algorithm>

#include "collision_monitor/geometry/ids.h"
#include "geometry/all_cores.h"
#include "geometry/bvh/bound_triangles.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

using Index = std::uint32_t;

// Builds nodes depth-first and reorders the items.
class Builder {
 public:
  Builder(double size, std::vector<SplitItem>& items, Index count, MeshNodes& built)
      : size_(size), items_(items), built_(built) {
    const std::size_t likely_count = count / 3 + 2;
    built_.nodes.reserve(likely_count);
    built_.extents.reserve(likely_count);
  }

  void addAll() {
    const SplitRange all = makeRange(items_.data(), 0, static_cast<Index>(items_.size()));
    addNode({all}, 1, 0);
  }

 private:
  static constexpr Index kWidth = MeshTreeNode::kWidth;
  using Parts = std::array<SplitRange, kWidth>;

  Index addNode(const Parts& parts, Index count, Index level) {
    const auto node = static_cast<Index>(built_.nodes.size());
    built_.nodes.emplace_back();
    built_.extents.emplace_back();
    for (Index slot = 0; slot < kWidth; ++slot) {
      boundNothing(slot, built_.nodes[node]);
    }
    for (Index slot = 0; slot < count; ++slot) {
      built_.extents[node][slot] = {parts[slot].first, parts[slot].count};
      boundByBox(parts[slot].box.low.head<3>(), parts[slot].box.high.head<3>(), size_, slot,
                 built_.nodes[node]);
    }
    if (level == 1 && items_.size() >= kManyTriangles) {
      addChildrenAtOnce(parts, count, node);
    } else {
      for (Index slot = 0; slot < count; ++slot) {
        const Index child = addChild(parts[slot], level);
        built_.nodes[node].child[slot] = child;
      }
    }
    return node;
  }

  // Adds the children of node 1.
  void addChildrenAtOnce(const Parts& parts, Index count, Index node) {
    std::array<MeshNodes, kWidth> below;
    std::array<Index, kWidth> child{};
    forEachOnAllCores(count, [&](std::size_t slot) {
      child[slot] = Builder(size_, items_, parts[slot].count, below[slot]).addChild(parts[slot], 1);
    });
    for (Index slot = 0; slot < count; ++slot) {
      const auto first = static_cast<Index>(built_.nodes.size());
      built_.nodes[node].child[slot] = moved(child[slot], first);
      append(below[slot]);
    }
  }

  // A child in a row of nodes that stands behind `first` others.
  static Index moved(Index child, Index first) {
    const bool is_node = child != kNone && (child & MeshTreeNode::kTriangle) == 0;
    return is_node ? first + child : child;
  }

  void append(const MeshNodes& below) {
    const auto first = static_cast<Index>(built_.nodes.size());
    for (const MeshTreeNode& node : below.nodes) {
      built_.nodes.push_back(node);
      for (Index& child : built_.nodes.back().child) {
        child = moved(child, first);
      }
    }
    built_.extents.insert(built_.extents.end(), below.extents.begin(), below.extents.end());
  }

  Index addChild(const SplitRange& range, Index level) {
    throwIfInterrupted();
    if (range.count == 1) {
      return MeshTreeNode::kTriangle + range.first;
    }
    Parts parts;
    const Index count =
        range.count <= kWidth ? separate(range, parts) : divide(range, level, parts);
    return addNode(parts, count, level + 1);
  }

  SplitRange single(Index item) const { return {item, 1, items_[item].box, {}}; }

  Index separate(const SplitRange& range, Parts& parts) const {
    for (Index i = 0; i < range.count; ++i) {
      parts[i] = single(range.first + i);
    }
    return range.count;
  }

  // Divides the largest part until the parts fill a node's slots, or each would fit a node of its
  // own. In the latter case the smallest parts move into this node, which saves their nodes.
  Index divide(const SplitRange& range, Index level, Parts& parts) {
    parts[0] = range;
    Index count = 1;
    while (count < kWidth) {
      Index largest = kWidth;
      float largest_area = -1.0F;
      for (Index i = 0; i < count; ++i) {
        const float area = parts[i].count > kWidth ? parts[i].box.area() : -1.0F;
        if (area > largest_area) {
          largest = i;
          largest_area = area;
        }
      }
      if (largest == kWidth) {
        return moveIn(count, parts);
      }
      const SplitRange whole = parts[largest];
      splitRange(items_.data(), whole, level >= MeshTree::kSplitByCount, parts[largest],
                 parts[count++]);
    }
    return count;
  }

  Index moveIn(Index count, Parts& parts) const {
    std::sort(parts.begin(), parts.begin() + count,
              [](const SplitRange& a, const SplitRange& b) { return a.count > b.count; });
    Index used = count;
    for (Index i = count; i-- > 0;) {
      const SplitRange part = parts[i];
      if (used - 1 + part.count > kWidth) {
        break;
      }
      for (Index j = 0; j < part.count; ++j) {
        parts[j == 0 ? i : used - 1 + j] = single(part.first + j);
      }
      used += part.count - 1;
    }
    return used;
  }

  double size_;
  std::vector<SplitItem>& items_;
  MeshNodes& built_;
};

}  // namespace

MeshNodes buildMeshNodes(double size, std::vector<SplitItem>& items) {
  MeshNodes built;
  Builder(size, items, static_cast<Index>(items.size()), built).addAll();
  return built;
}

}  // namespace collision_monitor
