// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/meshes/flat_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_set>

namespace collision_monitor {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// A triangle whose height is below this part of its longest edge is a line within the precision of
/// its numbers (float, 6e-8).
constexpr double kFlatness = 1e-12;

/// The edges and vertices that triangles hold, among the corners of flat ones. A vertex is an edge
/// to itself.
class HeldEdges {
 public:
  HeldEdges(const TriangleMesh& mesh, const std::vector<Corners>& flat)
      : is_asked_(mesh.vertices.size(), false) {
    for (const Corners& triangle : flat) {
      for (const std::uint32_t corner : triangle) {
        is_asked_[corner] = true;
      }
    }
    for (const Corners& triangle : mesh.triangles) {
      add(triangle);
    }
  }

  void add(const Corners& triangle) {
    for (const std::uint32_t from : triangle) {
      for (const std::uint32_t to : triangle) {
        if (is_asked_[from] && is_asked_[to]) {
          edges_.insert(keyOf(from, to));
        }
      }
    }
  }

  /// Whether the segment from [0] to [2] is held, as a whole or in two parts that meet in [1].
  bool hold(const Corners& segment) const {
    return has(segment[0], segment[2]) ||
           (has(segment[0], segment[1]) && has(segment[1], segment[2]));
  }

 private:
  static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) noexcept {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
  }
  bool has(std::uint32_t a, std::uint32_t b) const { return edges_.count(keyOf(a, b)) > 0; }

  std::vector<bool> is_asked_;  // by vertex
  std::unordered_set<std::uint64_t> edges_;
};

/// Puts the corner between the other two in the middle.
Corners alongLine(const Corners& flat, const std::vector<Eigen::Vector3d>& vertices) {
  const auto length = [&](std::size_t i, std::size_t k) {
    return (vertices[flat[i]] - vertices[flat[k]]).squaredNorm();
  };
  Corners line = flat;
  if (length(0, 1) > length(0, 2) && length(0, 1) >= length(1, 2)) {
    std::swap(line[1], line[2]);
  } else if (length(1, 2) > length(0, 2)) {
    std::swap(line[0], line[1]);
  }
  return line;
}

/// Leaves out what others hold. What is held holds its own parts, so this repeats.
void dropHeld(HeldEdges& held, std::vector<Corners>& lines) {
  constexpr int kMostRounds = 8;  // what is left after these is kept
  for (int round = 0; round < kMostRounds; ++round) {
    const auto open = std::remove_if(lines.begin(), lines.end(), [&](const Corners& line) {
      const bool is_held = held.hold(line);
      if (is_held) {
        held.add(line);
      }
      return is_held;
    });
    if (open == lines.end()) {
      return;
    }
    lines.erase(open, lines.end());
  }
}

}  // namespace

bool hasNoArea(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
               const Eigen::Vector3d& c) noexcept {
  const double longest_squared =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return !((b - a).cross(c - a).norm() > kFlatness * longest_squared);
}

void addFlatTriangles(std::vector<Corners> flat, TriangleMesh& mesh) {
  if (flat.empty()) {
    return;
  }
  for (Corners& triangle : flat) {
    triangle = alongLine(triangle, mesh.vertices);
  }
  HeldEdges held(mesh, flat);
  dropHeld(held, flat);
  for (const Corners& line : flat) {
    if (!held.hold(line)) {
      mesh.triangles.push_back({line[0], line[2], line[2]});
      held.add(line);
    }
  }
}

bool areAllFlat(const TriangleMesh& mesh) noexcept {
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [](const Corners& triangle) { return triangle[1] == triangle[2]; });
}

}  // namespace collision_monitor
