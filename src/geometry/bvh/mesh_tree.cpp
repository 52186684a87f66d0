// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/mesh_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "geometry/all_cores.h"
#include "geometry/bvh/bound_triangles.h"
#include "geometry/bvh/build_mesh_nodes.h"
#include "geometry/bvh/part_corners.h"
#include "geometry/bvh/split_triangles.h"
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

Vector3d normalOf(const Triangle& triangle) {
  return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
}

// By node and slot: the sum of the triangles' normals. Children stand behind their parents.
std::vector<std::array<Vector3d, kWidth>> sumNormals(const MeshNodes& built,
                                                     const std::vector<Triangle>& triangles) {
  std::vector<std::array<Vector3d, kWidth>> of_slots(built.nodes.size());
  std::vector<Vector3d> of_nodes(built.nodes.size(), Vector3d::Zero());
  for (std::size_t node = built.nodes.size(); node-- > 0;) {
    for (Index slot = 0; slot < kWidth; ++slot) {
      const SlotExtent& extent = built.extents[node][slot];
      if (extent.count > 0) {
        of_slots[node][slot] = extent.count == 1 ? normalOf(triangles[extent.first])
                                                 : of_nodes[built.nodes[node].child[slot]];
        of_nodes[node] += of_slots[node][slot];
      }
    }
  }
  return of_slots;
}

void boundBySlabs(const std::vector<Triangle>& triangles, const Vector3d& origin,
                  MeshNodes& built) {
  constexpr std::size_t kNodesOfJob = 1024;
  const std::vector<std::array<Vector3d, kWidth>> normals = sumNormals(built, triangles);
  const auto bound = [&](std::size_t node) {
    for (Index slot = 0; slot < kWidth; ++slot) {
      const SlotExtent& extent = built.extents[node][slot];
      if (extent.count > 0) {
        const Triangle* first = triangles.data() + extent.first;
        boundBySlab({first, first + extent.count}, normals[node][slot], origin, slot,
                    built.nodes[node]);
      }
    }
  };
  forEachOnAllCores(built.nodes.size() / kNodesOfJob + 1, [&](std::size_t job) {
    const std::size_t last = std::min(built.nodes.size(), (job + 1) * kNodesOfJob);
    for (std::size_t node = job * kNodesOfJob; node < last; ++node) {
      bound(node);
    }
  });
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
  MeshNodes built = buildMeshNodes(size, items);
  triangles_.reserve(items.size());
  source_triangles_.reserve(items.size());
  for (const SplitItem& item : items) {
    triangles_.push_back(triangleOf(mesh, item.triangle));
    source_triangles_.push_back(item.triangle);
  }
  boundBySlabs(triangles_, center_, built);
  nodes_ = std::move(built.nodes);
  const auto gather = [&] {
    part_corners_ = cornersOfParts(mesh, nodes_, source_triangles_, center_);
    pieces_ = piecesOf(mesh);
    probes_ = probesOf(pieces_, triangles_);
  };
  const auto findRim = [&] {
    if (is_open) {
      open_ = openSurfaceOf(mesh, *this);
    }
  };
  doBoth(items.size() >= kManyTriangles, gather, findRim);
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
