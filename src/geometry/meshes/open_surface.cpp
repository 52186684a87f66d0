// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/meshes/open_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Index = std::uint32_t;

// The triangles below a node, which are consecutive.
struct Range {
  Index first{0xffffffffU};
  Index last{0};

  void include(const Range& other) {
    first = std::min(first, other.first);
    last = std::max(last, other.last);
  }
};

double radiusAbout(const Vector3d& center, const std::vector<Triangle>& triangles,
                   const Range& range) {
  double squared = 0.0;
  for (Index i = range.first; i < range.last; ++i) {
    for (const Vector3d& corner : triangles[i]) {
      squared = std::max(squared, (corner - center).squaredNorm());
    }
  }
  return std::sqrt(squared) * (1.0 + 1e-15);
}

}  // namespace

std::vector<WindingMoments> momentsOf(const std::vector<MeshTreeNode>& nodes,
                                      const std::vector<Triangle>& triangles) {
  std::vector<WindingMoments> moments(nodes.size());
  std::vector<Range> ranges(nodes.size());
  // Children stand behind their parents.
  for (std::size_t node = nodes.size(); node-- > 0;) {
    for (const Index child : nodes[node].child) {
      if (child == kNone) {
        continue;
      }
      const bool is_triangle = (child & MeshTreeNode::kTriangle) != 0;
      const Index at = child & ~MeshTreeNode::kTriangle;
      const WindingMoments part = is_triangle ? momentsOf(triangles[at]) : moments[at];
      const bool is_first = ranges[node].last == 0;
      moments[node] = is_first ? part : joined(moments[node], part);
      ranges[node].include(is_triangle ? Range{at, at + 1} : ranges[at]);
    }
    moments[node].radius = radiusAbout(moments[node].center, triangles, ranges[node]);
  }
  return moments;
}

OpenSurface openSurfaceOf(const TriangleMesh& oriented) {
  // A rim with more edges than this share of the triangles costs more memory than it is worth.
  constexpr std::size_t kTrianglesAnEdge = 4;
  constexpr std::size_t kFewEdges = 100;
  const SurfaceRim rim = rimOf(oriented);
  OpenSurface open;
  open.rim_length = rim.length;
  const std::size_t edges = rim.edges.triangles.size();
  if (edges > 0 && (edges <= kFewEdges || kTrianglesAnEdge * edges <= oriented.triangles.size())) {
    open.rim.emplace(rim.edges);
  }
  return open;
}

std::vector<Vector3d> probesOf(const std::vector<Vector3d>& pieces,
                               const std::vector<Triangle>& triangles) {
  std::vector<Vector3d> directions = {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};
  for (const double y : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) {
      directions.emplace_back(1.0, y, z);
    }
  }
  std::vector<Vector3d> probes = pieces;
  for (const Vector3d& direction : directions) {
    Vector3d low = triangles.front()[0];
    Vector3d high = low;
    for (const Triangle& triangle : triangles) {
      for (const Vector3d& corner : triangle) {
        low = direction.dot(corner - low) < 0.0 ? corner : low;
        high = direction.dot(corner - high) > 0.0 ? corner : high;
      }
    }
    for (const Vector3d& farthest : {low, high}) {
      const auto own = probes.begin() + static_cast<std::ptrdiff_t>(pieces.size());
      if (std::find(own, probes.end(), farthest) == probes.end()) {
        probes.push_back(farthest);
      }
    }
  }
  return probes;
}

}  // namespace collision_monitor
