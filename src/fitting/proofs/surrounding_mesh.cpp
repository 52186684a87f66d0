// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/surrounding_mesh.h"

#include <cmath>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

constexpr int kSides = 48;
// Rounding of sines and of products of a few of them.
constexpr double kAllowance = 1e-14;

using Index = std::uint32_t;

/// A ring of vertices. Rings from lowest to highest, closed by fans at both ends, form a convex
/// body of revolution about z.
struct Ring {
  double radius;
  double z;
};

TriangleMesh revolve(const std::vector<Ring>& rings) {
  TriangleMesh mesh;
  for (const auto& ring : rings) {
    for (int side = 0; side < kSides; ++side) {
      const double angle = 2.0 * kPi * side / kSides;
      mesh.vertices.emplace_back(ring.radius * std::cos(angle), ring.radius * std::sin(angle),
                                 ring.z);
    }
  }
  const auto at = [](std::size_t ring, int side) {
    return static_cast<Index>(ring) * kSides + static_cast<Index>(side % kSides);
  };
  const std::size_t top = rings.size() - 1;
  for (int side = 0; side < kSides; ++side) {
    for (std::size_t ring = 0; ring < top; ++ring) {
      mesh.triangles.push_back({at(ring, side), at(ring, side + 1), at(ring + 1, side)});
      mesh.triangles.push_back({at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side)});
    }
    if (side > 0 && side + 1 < kSides) {
      mesh.triangles.push_back({at(0, 0), at(0, side + 1), at(0, side)});
      mesh.triangles.push_back({at(top, 0), at(top, side), at(top, side + 1)});
    }
  }
  return mesh;
}

/// The radius of the corners of a polygon around the unit circle.
double cornerRadius() { return (1.0 + kAllowance) / std::cos(kPi / kSides); }

}  // namespace

TriangleMesh surroundingMesh(const Box& box) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d signs((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                                (i & 4) != 0 ? 1.0 : -1.0);
    mesh.vertices.emplace_back(signs.cwiseProduct(box.half_extents));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TriangleMesh surroundingMesh(const Cylinder& cylinder) {
  const double radius = cylinder.radius * cornerRadius();
  return revolve({{radius, -cylinder.half_length}, {radius, cylinder.half_length}});
}

TriangleMesh surroundingMesh(const Capsule& capsule) {
  // A profile around a half disc, with tangents every 2 a: its corners are at 1 / cos(a) from the
  // center. Revolving it in flat steps widens it once more, by the polygon's factor.
  constexpr int kTangents = kSides / 2;  // from pole to pole, both included
  const double half_step = 0.5 * kPi / kTangents;
  const double corner = capsule.radius * (1.0 + kAllowance) / std::cos(half_step);
  std::vector<Ring> rings;
  for (int i = 0; i < kTangents; ++i) {
    // Corners lie half a step from the poles and never on the equator.
    const double latitude = -0.5 * kPi + half_step * (2 * i + 1);
    const double shift = latitude < 0.0 ? -capsule.half_length : capsule.half_length;
    rings.push_back(
        {corner * std::cos(latitude) * cornerRadius(), corner * std::sin(latitude) + shift});
  }
  return revolve(rings);
}

}  // namespace collision_monitor
