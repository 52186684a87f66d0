// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/mesh_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "geometry/bvh/bound_triangles.h"
#include "geometry/bvh/part_corners.h"
#include "geometry/bvh/split_triangles.h"
#include "geometry/interruption.h"
#include "geometry/meshes/check_mesh.h"
#include "geometry/meshes/mesh_pieces.h"
#include "geometry/meshes/open_surface.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Index = std::uint32_t;

constexpr Index kWidth = MeshTreeNode::kWidth;

Index primitiveCount(const TriangleMesh& mesh) {
  return static_cast<Index>(mesh.triangles.empty() ? mesh.vertices.size() : mesh.triangles.size());
}

Triangle triangleOf(const TriangleMesh& mesh, Index i) {
  if (mesh.triangles.empty()) {
    return {mesh.vertices[i], mesh.vertices[i], mesh.vertices[i]};
  }
  const auto& corners = mesh.triangles[i];
  return {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
}

// Single precision is enough to group triangles.
std::vector<SplitItem> itemsOf(const TriangleMesh& mesh, const Vector3d& origin) {
  std::vector<SplitItem> items(primitiveCount(mesh));
  for (Index i = 0; i < items.size(); ++i) {
    items[i].triangle = i;
    for (const Vector3d& corner : triangleOf(mesh, i)) {
      const Eigen::Vector3f here = (corner - origin).cast<float>();
      items[i].box.include(Array4(here.x(), here.y(), here.z(), 0.0F));
    }
  }
  return items;
}

using Parts = std::array<SplitRange, kWidth>;

// Builds nodes depth-first and reorders the items. Bounds follow once the order is final.
class Builder {
 public:
  // The triangles of a slot, in the order of the tree.
  struct Extent {
    Index first{0};
    Index count{0};  // 0: the slot is empty
  };
  using Extents = std::array<Extent, kWidth>;

  // @param size bounds every coordinate.
  Builder(double size, std::vector<SplitItem>& items, std::vector<MeshTreeNode>& nodes)
      : size_(size), items_(items), nodes_(nodes) {
    const std::size_t likely_count = items.size() / 3 + 2;
    nodes_.reserve(likely_count);
    extents_.reserve(likely_count);
  }

  void addAll() {
    const SplitRange all = makeRange(items_.data(), 0, static_cast<Index>(items_.size()));
    addNode({all}, 1, 0);
  }

  const std::vector<Extents>& extents() const { return extents_; }

 private:
  Index addNode(const Parts& parts, Index count, Index level) {
    const auto node = static_cast<Index>(nodes_.size());
    nodes_.emplace_back();
    extents_.emplace_back();
    for (Index slot = 0; slot < kWidth; ++slot) {
      boundNothing(slot, nodes_[node]);
    }
    for (Index slot = 0; slot < count; ++slot) {
      extents_[node][slot] = {parts[slot].first, parts[slot].count};
      boundByBox(parts[slot].box.low.head<3>(), parts[slot].box.high.head<3>(), size_, slot,
                 nodes_[node]);
      const Index child = addChild(parts[slot], level);
      nodes_[node].child[slot] = child;
    }
    return node;
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
  std::vector<MeshTreeNode>& nodes_;
  std::vector<Extents> extents_;
};

Vector3d normalOf(const Triangle& triangle) {
  return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
}

// Children stand behind their parents. So a backward loop can sum the normals of a node's children.
void boundBySlabs(const std::vector<Builder::Extents>& extents,
                  const std::vector<Triangle>& triangles, const Vector3d& origin,
                  std::vector<MeshTreeNode>& nodes) {
  std::vector<Vector3d> normals(nodes.size(), Vector3d::Zero());
  for (std::size_t node = nodes.size(); node-- > 0;) {
    for (Index slot = 0; slot < kWidth; ++slot) {
      const Builder::Extent& extent = extents[node][slot];
      if (extent.count > 0) {
        const Triangle* first = triangles.data() + extent.first;
        const Vector3d normal =
            extent.count == 1 ? normalOf(*first) : normals[nodes[node].child[slot]];
        boundBySlab({first, first + extent.count}, normal, origin, slot, nodes[node]);
        normals[node] += normal;
      }
    }
  }
}

}  // namespace

MeshTree MeshTree::ofOriented(const TriangleMesh& oriented) {
  checkMesh(oriented, kMaxMeasured);
  return MeshTree(oriented, false, true);
}

MeshTree::MeshTree(const TriangleMesh& mesh, bool is_closed) : MeshTree(mesh, is_closed, false) {}

MeshTree::MeshTree(const TriangleMesh& mesh, bool is_closed, bool is_open) : is_closed_(is_closed) {
  checkMesh(mesh, kMaxMeasured);
  Vector3d low = mesh.vertices.front();
  Vector3d high = low;
  for (const Vector3d& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  center_ = 0.5 * (low + high);
  radius_ = (high - center_).norm() * (1.0 + 1e-15);
  std::vector<SplitItem> items = itemsOf(mesh, center_);
  const double size = low.cwiseAbs().maxCoeff() + high.cwiseAbs().maxCoeff();
  Builder builder(size, items, nodes_);
  builder.addAll();
  triangles_.reserve(items.size());
  source_triangles_.reserve(items.size());
  for (const SplitItem& item : items) {
    triangles_.push_back(triangleOf(mesh, item.triangle));
    source_triangles_.push_back(item.triangle);
  }
  boundBySlabs(builder.extents(), triangles_, center_, nodes_);
  part_corners_ = cornersOfParts(mesh, nodes_, source_triangles_, center_);
  pieces_ = piecesOf(mesh);
  probes_ = probesOf(pieces_, triangles_);
  if (is_open) {
    open_ = openSurfaceOf(mesh, *this);
  }
}

void MeshTree::setHull(const std::vector<ConvexHull::Face>& hull) {
  if (!open_) {
    return;
  }
  open_->hull = hull;
  open_->hull_ball = std::numeric_limits<double>::infinity();
  for (const ConvexHull::Face& face : hull) {
    open_->hull_ball = std::min(open_->hull_ball, face.offset - face.normal.dot(center_));
  }
}

}  // namespace collision_monitor
