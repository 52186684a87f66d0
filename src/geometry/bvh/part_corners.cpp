// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/bvh/part_corners.h"

#include <algorithm>

#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {

/// Adds node after node. Corners of a node's own triangles, and of those below its small children,
/// come first; those of its other children follow, because they stand behind it.
class PartCornersBuilder {
 public:
  PartCornersBuilder(const TriangleMesh& mesh, const std::vector<MeshTreeNode>& nodes,
                     const std::vector<std::uint32_t>& source, const Eigen::Vector3d& center)
      : mesh_(mesh), nodes_(nodes), source_(source), center_(center) {}

  PartCorners build() {
    countTriangles();
    corners_.ranges_.resize(nodes_.size());
    last_node_of_.assign(mesh_.vertices.size(), kNone);
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
      corners_.ranges_[node].first = size_;
      if (isPart(node)) {
        addOwn(node);
      }
      corners_.ranges_[node].last = size_;
    }
    joinRanges();
    return std::move(corners_);
  }

 private:
  static bool isTriangle(std::uint32_t child) { return (child & MeshTreeNode::kTriangle) != 0; }

  bool isPart(std::uint32_t node) const { return counts_[node] >= PartCorners::kFewTriangles; }

  void countTriangles() {
    counts_.assign(nodes_.size(), 0);
    for (std::size_t node = nodes_.size(); node-- > 0;) {
      for (const std::uint32_t child : nodes_[node].child) {
        counts_[node] += child == kNone ? 0 : isTriangle(child) ? 1 : counts_[child];
      }
    }
  }

  void addOwn(std::uint32_t node) {
    own_.clear();
    for (const std::uint32_t child : nodes_[node].child) {
      if (child != kNone && (isTriangle(child) || !isPart(child))) {
        gather(child, node);
      }
    }
    if (own_.empty()) {
      return;
    }
    while (own_.size() % PartCorners::kStep != 0) {
      own_.push_back(own_.back());
    }
    for (int axis = 0; axis < 3; ++axis) {
      auto& column = corners_.columns_[static_cast<std::size_t>(axis)];
      for (std::size_t i = 0; i < own_.size(); ++i) {
        if (i % PartCorners::kStep == 0) {
          column.emplace_back();
        }
        column.back().at[i % PartCorners::kStep] =
            static_cast<float>(mesh_.vertices[own_[i]][axis] - center_[axis]);
      }
    }
    size_ += static_cast<std::uint32_t>(own_.size());
  }

  // Each vertex once for a node.
  void gather(std::uint32_t child, std::uint32_t for_node) {
    if (!isTriangle(child)) {
      for (const std::uint32_t below : nodes_[child].child) {
        if (below != kNone) {
          gather(below, for_node);
        }
      }
      return;
    }
    const std::uint32_t triangle = source_[child & ~MeshTreeNode::kTriangle];
    const auto add = [&](std::uint32_t vertex) {
      if (last_node_of_[vertex] != for_node) {
        last_node_of_[vertex] = for_node;
        own_.push_back(vertex);
      }
    };
    if (mesh_.triangles.empty()) {
      add(triangle);
    } else {
      std::for_each(mesh_.triangles[triangle].begin(), mesh_.triangles[triangle].end(), add);
    }
  }

  // The range of a node ends where that of its last part ends. Too large ones become empty.
  void joinRanges() {
    std::vector<PartCorners::Range>& ranges = corners_.ranges_;
    for (std::size_t node = nodes_.size(); node-- > 0;) {
      for (const std::uint32_t child : nodes_[node].child) {
        if (child != kNone && !isTriangle(child)) {
          ranges[node].last = std::max(ranges[node].last, ranges[child].last);
        }
      }
    }
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const bool is_large = ranges[node].last - ranges[node].first > PartCorners::kMostCorners;
      if (is_large || counts_[node] < PartCorners::kFewTriangles) {
        ranges[node].last = ranges[node].first;
      }
    }
  }

  const TriangleMesh& mesh_;
  const std::vector<MeshTreeNode>& nodes_;
  const std::vector<std::uint32_t>& source_;
  const Eigen::Vector3d& center_;
  std::vector<std::uint32_t> counts_;        // by node: its triangles
  std::vector<std::uint32_t> last_node_of_;  // by vertex: for which it was added last
  std::vector<std::uint32_t> own_;           // vertices
  std::uint32_t size_{0};
  PartCorners corners_;
};

PartCorners cornersOfParts(const TriangleMesh& mesh, const std::vector<MeshTreeNode>& nodes,
                           const std::vector<std::uint32_t>& source,
                           const Eigen::Vector3d& center) {
  return PartCornersBuilder(mesh, nodes, source, center).build();
}

}  // namespace collision_monitor
