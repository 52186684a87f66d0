// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/hulls/hull_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "geometry/bvh/vertex_blocks.h"

namespace collision_monitor {
namespace {

constexpr double kFlat = 1e-13;  // of the extent: corners this near to a plane lie in it

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

// The triangles along each edge, sorted by edge. A diagonal of a flat hull belongs to a triangle on
// either side.
class TriangleOfEdge {
 public:
  using Entry = std::pair<DirectedEdge, std::uint32_t>;

  explicit TriangleOfEdge(const TriangleMesh& mesh) {
    entries_.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& corners = mesh.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        entries_.push_back({{corners[k], corners[(k + 1) % 3]}, t});
      }
    }
    std::sort(entries_.begin(), entries_.end());
    first_.assign(mesh.vertices.size() + 1, 0);
    for (const Entry& entry : entries_) {
      ++first_[entry.first.first + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  const std::vector<Entry>& all() const { return entries_; }

  std::pair<const Entry*, const Entry*> of(const DirectedEdge& edge) const {
    const Entry* first = entries_.data() + first_[edge.first];
    const Entry* const end = entries_.data() + first_[edge.first + 1];
    const auto is_before = [&](const Entry& entry) { return entry.first.second < edge.second; };
    first = std::partition_point(first, end, is_before);
    const Entry* last = first;
    while (last != end && last->first == edge) {
      ++last;
    }
    return {first, last};
  }

 private:
  std::vector<Entry> entries_;
  std::vector<std::size_t> first_;  // by the vertex where an edge begins
};

Eigen::Vector3d crossOf(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& corners = mesh.triangles[triangle];
  const Eigen::Vector3d& a = mesh.vertices[corners[0]];
  return (mesh.vertices[corners[1]] - a).cross(mesh.vertices[corners[2]] - a);
}

// The face through the farthest vertex along `normal`, which is near the triangle.
ConvexHull::Face supportingFace(const TriangleMesh& mesh, const VertexBlocks& blocks,
                                const Eigen::Vector3d& normal, std::uint32_t triangle) {
  const std::uint32_t farthest = blocks.farthest(normal, mesh.triangles[triangle][0]);
  return {normal, normal.dot(mesh.vertices[farthest])};
}

bool liesIn(const ConvexHull::Face& face, const TriangleMesh& mesh, std::uint32_t triangle,
            double slack) {
  // Needed for a flat hull, which has two faces in one plane.
  const auto& corners = mesh.triangles[triangle];
  return std::all_of(corners.begin(), corners.end(),
                     [&](std::uint32_t corner) {
                       return face.normal.dot(mesh.vertices[corner]) >= face.offset - slack;
                     }) &&
         crossOf(mesh, triangle).dot(face.normal) >= 0.0;
}

// Gives the number `id` to every triangle in the plane of `face` that is connected to `seed`.
void floodFace(const TriangleMesh& mesh, const TriangleOfEdge& triangle_of, std::uint32_t seed,
               const ConvexHull::Face& face, double slack, std::uint32_t id,
               std::vector<std::uint32_t>& face_of) {
  std::vector<std::uint32_t> open{seed};
  face_of[seed] = id;
  while (!open.empty()) {
    const auto corners = mesh.triangles[open.back()];
    open.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [first, last] = triangle_of.of({corners[(k + 1) % 3], corners[k]});
      for (const auto* next = first; next != last; ++next) {
        if (face_of[next->second] == kNone && liesIn(face, mesh, next->second, slack)) {
          face_of[next->second] = id;
          open.push_back(next->second);
        }
      }
    }
  }
}

std::vector<ConvexHull::Edge> edgesBetween(const TriangleOfEdge& triangle_of,
                                           const std::vector<std::uint32_t>& face_of) {
  std::vector<ConvexHull::Edge> edges;
  for (const auto& [edge, triangle] : triangle_of.all()) {
    if (edge.first > edge.second) {
      continue;
    }
    const auto [own, own_end] = triangle_of.of(edge);
    const auto [other, other_end] = triangle_of.of({edge.second, edge.first});
    if (other == other_end || own_end - own > 1) {
      continue;
    }
    const std::uint32_t left = face_of[triangle];
    const std::uint32_t right = face_of[other->second];
    if (left != right && left != kNone && right != kNone) {
      edges.push_back({edge.first, edge.second, left, right});
    }
  }
  return edges;
}

// Each face runs along each of its edges in one direction. Slivers without area may leave a gap,
// where the ring ends.
std::vector<std::vector<std::uint32_t>> ringsOf(const HullFaces& gathered) {
  std::vector<std::map<std::uint32_t, std::uint32_t>> next(gathered.faces.size());
  for (const ConvexHull::Edge& edge : gathered.edges) {
    next[edge.left][edge.from] = edge.to;
    next[edge.right][edge.to] = edge.from;
  }
  std::vector<std::vector<std::uint32_t>> rings(next.size());
  for (std::size_t face = 0; face < next.size(); ++face) {
    auto at = next[face].begin();
    while (at != next[face].end() && rings[face].size() < next[face].size()) {
      rings[face].push_back(at->first);
      at = next[face].find(at->second);
    }
  }
  return rings;
}

// Whether the faces leave no gap: the numbers of corners, edges and faces are those of a closed
// surface (Euler), and the faces lean outward at each edge.
bool areClosed(const HullFaces& gathered, const TriangleMesh& mesh) {
  std::set<std::uint32_t> corners;
  for (const ConvexHull::Edge& edge : gathered.edges) {
    corners.insert({edge.from, edge.to});
    const Eigen::Vector3d along = mesh.vertices[edge.to] - mesh.vertices[edge.from];
    const Eigen::Vector3d& left = gathered.faces[edge.left].normal;
    if (!(left.cross(gathered.faces[edge.right].normal).dot(along) > 0.0)) {
      return false;
    }
  }
  return corners.size() + gathered.faces.size() == gathered.edges.size() + 2;
}

}  // namespace

HullFaces gatherFaces(const TriangleMesh& mesh, double extent) {
  HullFaces gathered;
  const TriangleOfEdge triangle_of(mesh);
  const VertexBlocks blocks(mesh.vertices);
  std::vector<double> areas(mesh.triangles.size());
  for (std::uint32_t t = 0; t < areas.size(); ++t) {
    areas[t] = crossOf(mesh, t).norm();
  }
  std::vector<std::uint32_t> order(areas.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
  std::vector<std::uint32_t> face_of(areas.size(), kNone);
  for (const std::uint32_t seed : order) {
    if (face_of[seed] == kNone && areas[seed] > 0.0) {
      const auto id = static_cast<std::uint32_t>(gathered.faces.size());
      gathered.faces.push_back(
          supportingFace(mesh, blocks, crossOf(mesh, seed) / areas[seed], seed));
      floodFace(mesh, triangle_of, seed, gathered.faces.back(), kFlat * extent, id, face_of);
    }
  }
  gathered.edges = edgesBetween(triangle_of, face_of);
  gathered.rings = ringsOf(gathered);
  const bool is_flat = gathered.faces.size() == 2;
  if (!is_flat && !areClosed(gathered, mesh)) {
    gathered.edges.clear();
  }
  return gathered;
}

}  // namespace collision_monitor
