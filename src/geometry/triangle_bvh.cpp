// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/triangle_bvh.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "collision_monitor/geometry/point_triangle.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Triangle = TriangleBvh::Triangle;
using Node = TriangleBvh::Node;

constexpr std::uint32_t kLeafSize = 1;
// The median split halves every range, so 32 levels hold any mesh with 32-bit indices.
constexpr std::size_t kMaxDepth = 34;

void checkMesh(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) {
    throw std::invalid_argument("mesh: no vertices; at least one is needed");
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!mesh.vertices[i].allFinite()) {
      throw std::invalid_argument("mesh: vertex " + std::to_string(i) +
                                  " is not finite; every coordinate must be");
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const auto corner : mesh.triangles[i]) {
      if (corner >= mesh.vertices.size()) {
        throw std::invalid_argument("mesh: triangle " + std::to_string(i) + " names vertex " +
                                    std::to_string(corner) + "; there are " +
                                    std::to_string(mesh.vertices.size()) + ", counted from 0");
      }
    }
  }
}

std::vector<Triangle> trianglesOf(const TriangleMesh& mesh) {
  std::vector<Triangle> triangles;
  triangles.reserve(std::max(mesh.triangles.size(), mesh.vertices.size()));
  for (const auto& t : mesh.triangles) {
    triangles.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  }
  if (triangles.empty()) {
    for (const auto& vertex : mesh.vertices) {
      triangles.push_back({vertex, vertex, vertex});
    }
  }
  return triangles;
}

Aabb boundsOf(const Triangle* first, const Triangle* last) {
  Aabb box{(*first)[0], (*first)[0]};
  for (; first != last; ++first) {
    for (const auto& corner : *first) {
      box.min = box.min.cwiseMin(corner);
      box.max = box.max.cwiseMax(corner);
    }
  }
  return box;
}

/// Three times the centroid: enough to sort by.
double cornerSum(const Triangle& triangle, Eigen::Index axis) {
  // The analyzer loses track of the moves in nth_element. NOLINTNEXTLINE(clang-analyzer-*)
  return triangle[0][axis] + triangle[1][axis] + triangle[2][axis];
}

/// Sorts the range about its median along its longest axis and returns the size of the lower half.
std::uint32_t splitAtMedian(const Aabb& bounds, Triangle* first, std::uint32_t count) {
  Eigen::Index axis = 0;
  (bounds.max - bounds.min).maxCoeff(&axis);
  const std::uint32_t half = count / 2;
  std::nth_element(first, first + half, first + count, [axis](const auto& a, const auto& b) {
    return cornerSum(a, axis) < cornerSum(b, axis);
  });
  return half;
}

}  // namespace

TriangleBvh::TriangleBvh(const TriangleMesh& mesh) {
  checkMesh(mesh);
  triangles_ = trianglesOf(mesh);
  nodes_.reserve(2 * triangles_.size());
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(triangles_.size())});
  // Nodes are appended while this runs: breadth-first, parents before children.
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::uint32_t first = nodes_[i].first;
    const std::uint32_t count = nodes_[i].count;
    Triangle* begin = triangles_.data() + first;
    nodes_[i].bounds = boundsOf(begin, begin + count);
    if (count > kLeafSize) {
      const std::uint32_t half = splitAtMedian(nodes_[i].bounds, begin, count);
      nodes_[i].first = static_cast<std::uint32_t>(nodes_.size());
      nodes_[i].count = 0;
      nodes_.push_back({{}, first, half});
      nodes_.push_back({{}, first + half, count - half});
    }
  }
}

NearestPoint TriangleBvh::nearestOn(std::uint32_t leaf_triangle,
                                    const Vector3d& point) const noexcept {
  const Triangle& triangle = triangles_[leaf_triangle];
  NearestPoint nearest;
  nearest.point = closestPointOnTriangle(point, triangle[0], triangle[1], triangle[2]);
  nearest.distance = (nearest.point - point).norm();
  nearest.leaf_triangle = leaf_triangle;
  return nearest;
}

NearestPoint TriangleBvh::nearestTo(const Vector3d& point, const NearestPoint& start,
                                    double tolerance) const noexcept {
  struct Waiting {
    std::uint32_t node;
    double squared_distance;
  };
  std::array<Waiting, kMaxDepth> stack;
  std::size_t size = 0;
  const double slack = (1.0 + tolerance) * (1.0 + tolerance);
  NearestPoint best = start;
  stack[size++] = {0, squaredDistance(nodes_[0].bounds, point)};
  while (size > 0) {
    const Waiting next = stack[--size];
    if (slack * next.squared_distance >= best.distance * best.distance) {
      continue;
    }
    const Node& node = nodes_[next.node];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const NearestPoint found = nearestOn(i, point);
      best = found.distance < best.distance ? found : best;
    }
    if (node.count == 0) {
      Waiting near{node.first, squaredDistance(nodes_[node.first].bounds, point)};
      Waiting far{node.first + 1, squaredDistance(nodes_[node.first + 1].bounds, point)};
      if (far.squared_distance < near.squared_distance) {
        std::swap(near, far);
      }
      stack[size++] = far;
      stack[size++] = near;
    }
  }
  return best;
}

}  // namespace collision_monitor
