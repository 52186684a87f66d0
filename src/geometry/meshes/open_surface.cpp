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

std::vector<WindingMoments> momentsOfNodes(const std::vector<MeshTreeNode>& nodes,
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

SurfaceRim rimOf(const std::vector<Triangle>& triangles, const std::vector<std::uint8_t>& sides) {
  SurfaceRim rim;
  for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      if ((sides[triangle] >> i & 1U) != 0) {
        rim.add(triangles[triangle][i], triangles[triangle][(i + 1) % 3]);
      }
    }
  }
  return rim;
}

double lengthOf(const Triangle& triangle, std::uint8_t sides) {
  double length = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    length += (sides >> i & 1U) != 0 ? (triangle[(i + 1) % 3] - triangle[i]).norm() : 0.0;
  }
  return length;
}

std::vector<float> rimLengthsOf(const MeshTree& tree, const std::vector<std::uint8_t>& rim_sides) {
  constexpr double kUp = 1.0 + 1e-6;  // more than the roundings of all levels
  std::vector<double> lengths(tree.nodes().size(), 0.0);
  for (std::size_t node = lengths.size(); node-- > 0;) {
    for (const Index child : tree.nodes()[node].child) {
      if (child != kNone) {
        const Index at = child & ~MeshTreeNode::kTriangle;
        lengths[node] += (child & MeshTreeNode::kTriangle) != 0
                             ? lengthOf(tree.triangles()[at], rim_sides[at])
                             : lengths[at];
      }
    }
  }
  std::vector<float> rounded;
  rounded.reserve(lengths.size());
  for (const double length : lengths) {
    rounded.push_back(static_cast<float>(kUp * length));
  }
  return rounded;
}

}  // namespace

OpenSurface openSurfaceOf(const TriangleMesh& oriented, const MeshTree& tree) {
  // Up to here the sides take less time than moments.
  constexpr std::size_t kMostSides = 4096;
  const std::vector<std::uint8_t> by_source = rimSidesOf(oriented);
  OpenSurface open;
  open.rim_sides.reserve(tree.sourceTriangles().size());
  for (const Index source : tree.sourceTriangles()) {
    open.rim_sides.push_back(source < by_source.size() ? by_source[source] : std::uint8_t{0});
  }
  open.rim = rimOf(tree.triangles(), open.rim_sides);
  if (open.rim.size() <= kMostSides) {
    open.rim_sides = {};
    return open;
  }
  open.rim = {};
  open.moments = momentsOfNodes(tree.nodes(), tree.triangles());
  open.rim_lengths = rimLengthsOf(tree, open.rim_sides);
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
