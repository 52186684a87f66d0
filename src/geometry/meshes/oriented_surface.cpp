// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/geometry/winding.h"
#include "geometry/meshes/triangle_sides.h"
#include "geometry/meshes/weld_vertices.h"

namespace collision_monitor {
namespace {

using Corners = std::array<std::uint32_t, 3>;

std::vector<Corners> weldedTriangles(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> first = firstEquals(mesh.vertices);
  std::vector<Corners> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    triangles.push_back({first[t[0]], first[t[1]], first[t[2]]});
  }
  return triangles;
}

// Keeps the first of the triangles with the same corners.
void dropCopies(std::vector<Corners>& triangles) {
  std::vector<std::pair<Corners, std::uint32_t>> sorted;
  sorted.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    sorted.push_back({triangles[i], i});
    std::sort(sorted.back().first.begin(), sorted.back().first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) {
      Corners& copy = triangles[sorted[i].second];
      copy = {copy[0], copy[0], copy[0]};
    }
  }
}

// A neighbour of a triangle, and whether it has to be turned to agree.
struct Neighbour {
  std::uint32_t triangle;
  bool disagrees;
};
using Neighbours = std::vector<std::array<Neighbour, 3>>;

Neighbours neighboursOf(const std::vector<Corners>& triangles, std::size_t vertex_count) {
  Neighbours neighbours(triangles.size(), {{{kNone, false}, {kNone, false}, {kNone, false}}});
  const auto add = [&](const TriangleSide& side, const TriangleSide& other) {
    const auto free =
        std::find_if(neighbours[side.triangle].begin(), neighbours[side.triangle].end() - 1,
                     [](const Neighbour& n) { return n.triangle == kNone; });
    *free = {other.triangle, side.is_forward == other.is_forward};
  };
  forEdges(sidesOf(triangles, vertex_count), [&](auto first, auto last) {
    if (last - first == 2) {
      add(*first, *(first + 1));
      add(*(first + 1), *first);
    }
  });
  return neighbours;
}

double areaOf(const TriangleMesh& mesh, const Corners& t) {
  return (mesh.vertices[t[1]] - mesh.vertices[t[0]])
      .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
      .norm();
}

// Walks from triangle to neighbour. Each connected part keeps the direction of most of its area.
class Turning {
 public:
  Turning(const TriangleMesh& mesh, std::vector<Corners>& triangles)
      : mesh_(mesh),
        triangles_(triangles),
        neighbours_(neighboursOf(triangles, mesh.vertices.size())),
        is_seen_(triangles.size(), 0),
        turns_(triangles.size(), 0) {}

  void turnAll() {
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      if (is_seen_[i] == 0) {
        turnPart(i);
      }
    }
  }

 private:
  void turnPart(std::uint32_t first) {
    part_ = {first};
    is_seen_[first] = 1;
    double turned = 0.0;
    double all = 0.0;
    for (std::size_t next = 0; next < part_.size(); ++next) {
      const std::uint32_t triangle = part_[next];
      const double area = areaOf(mesh_, triangles_[triangle]);
      all += area;
      turned += turns_[triangle] != 0 ? area : 0.0;
      for (const Neighbour& neighbour : neighbours_[triangle]) {
        if (neighbour.triangle != kNone && is_seen_[neighbour.triangle] == 0) {
          is_seen_[neighbour.triangle] = 1;
          turns_[neighbour.triangle] = turns_[triangle] ^ (neighbour.disagrees ? 1 : 0);
          part_.push_back(neighbour.triangle);
        }
      }
    }
    constexpr double kMost = 0.5 + 1e-9;  // rounding must not decide between equal halves
    const unsigned char to_turn = turned > kMost * all ? 0 : 1;
    for (const std::uint32_t triangle : part_) {
      if (turns_[triangle] == to_turn) {
        std::swap(triangles_[triangle][1], triangles_[triangle][2]);
      }
    }
  }

  const TriangleMesh& mesh_;
  std::vector<Corners>& triangles_;
  Neighbours neighbours_;
  std::vector<unsigned char> is_seen_;
  std::vector<unsigned char> turns_;  // whether to agree with the first of its part
  std::vector<std::uint32_t> part_;
};

}  // namespace

TriangleMesh orientedSurface(const TriangleMesh& mesh) {
  std::vector<Corners> triangles = weldedTriangles(mesh);
  dropCopies(triangles);
  Turning(mesh, triangles).turnAll();
  return {mesh.vertices, std::move(triangles)};
}

std::vector<std::uint8_t> rimSidesOf(const TriangleMesh& mesh) {
  const std::vector<Corners> triangles = weldedTriangles(mesh);
  std::vector<std::uint8_t> rim(triangles.size(), 0);
  const auto mark = [&](const TriangleSide& side) {
    const Corners& corners = triangles[side.triangle];
    const std::uint32_t from = side.is_forward ? side.low : side.high;
    const auto place = std::find(corners.begin(), corners.end(), from) - corners.begin();
    rim[side.triangle] = static_cast<std::uint8_t>(rim[side.triangle] | 1U << place);
  };
  forEdges(sidesOf(triangles, mesh.vertices.size()), [&](auto first, auto last) {
    int ends = 0;
    for (auto side = first; side != last; ++side) {
      ends += side->is_forward ? 1 : -1;
    }
    const bool is_forward = ends > 0;
    for (auto side = first; side != last && ends != 0; ++side) {
      if (side->is_forward == is_forward) {
        mark(*side);
        ends += is_forward ? -1 : 1;
      }
    }
  });
  return rim;
}

}  // namespace collision_monitor
