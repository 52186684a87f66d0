// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/hulls/hull_graph.h"

#include <algorithm>
#include <numeric>

namespace collision_monitor {
namespace {

using Lists = std::vector<std::vector<std::uint32_t>>;

constexpr double kShortEdge = 1e-5;  // of the extent: a slope of 1e-11
constexpr std::size_t kMostNeighbours = 512;

void sortOnce(std::vector<std::uint32_t>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

Lists neighboursOf(const TriangleMesh& hull) {
  Lists neighbours(hull.vertices.size());
  for (const auto& corners : hull.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      neighbours[corners[k]].push_back(corners[(k + 1) % 3]);
      neighbours[corners[(k + 1) % 3]].push_back(corners[k]);
    }
  }
  std::for_each(neighbours.begin(), neighbours.end(), sortOnce);
  return neighbours;
}

// By vertex: a vertex that stands for all vertices joined to it by short edges.
std::vector<std::uint32_t> clustersOf(const TriangleMesh& hull, const Lists& neighbours,
                                      double short_edge) {
  std::vector<std::uint32_t> parent(neighbours.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto rootOf = [&](std::uint32_t vertex) {
    while (parent[vertex] != vertex) {
      vertex = parent[vertex] = parent[parent[vertex]];
    }
    return vertex;
  };
  for (std::uint32_t from = 0; from < neighbours.size(); ++from) {
    for (const std::uint32_t to : neighbours[from]) {
      if ((hull.vertices[to] - hull.vertices[from]).norm() <= short_edge) {
        parent[rootOf(from)] = rootOf(to);
      }
    }
  }
  std::vector<std::uint32_t> roots(neighbours.size());
  for (std::uint32_t vertex = 0; vertex < roots.size(); ++vertex) {
    roots[vertex] = rootOf(vertex);
  }
  return roots;
}

}  // namespace

Lists neighboursToClimb(const TriangleMesh& hull, double extent) {
  if (hull.triangles.empty()) {
    return {};
  }
  Lists neighbours = neighboursOf(hull);
  const std::vector<std::uint32_t> cluster = clustersOf(hull, neighbours, kShortEdge * extent);
  Lists around(neighbours.size());  // by cluster, including its own vertices
  for (std::uint32_t vertex = 0; vertex < neighbours.size(); ++vertex) {
    std::vector<std::uint32_t>& all = around[cluster[vertex]];
    all.push_back(vertex);
    all.insert(all.end(), neighbours[vertex].begin(), neighbours[vertex].end());
  }
  for (std::uint32_t vertex = 0; vertex < neighbours.size(); ++vertex) {
    std::vector<std::uint32_t>& all = around[cluster[vertex]];
    sortOnce(all);
    if (all.size() > std::max(kMostNeighbours, neighbours[vertex].size() + 1)) {
      return {};
    }
    neighbours[vertex] = all;
    neighbours[vertex].erase(std::lower_bound(all.begin(), all.end(), vertex) - all.begin() +
                             neighbours[vertex].begin());
  }
  return neighbours;
}

}  // namespace collision_monitor
