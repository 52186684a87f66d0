// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface_mesh.h"

#include <cmath>

#include "geometry/constants.h"

namespace collision_monitor::fit_tool {
namespace {

constexpr int kSectors = 96;
constexpr int kQuarter = kSectors / 4;

using Profile = std::vector<Eigen::Vector2d>;  // (distance from the axis, height), upwards

/// Turns a profile about z. Rings on the axis shrink to a point; their triangles without area do no
/// harm.
TriangleMesh turned(const Profile& profile) {
  TriangleMesh mesh;
  for (const Eigen::Vector2d& corner : profile) {
    for (int i = 0; i < kSectors; ++i) {
      const double angle = 2.0 * kPi * i / kSectors;
      mesh.vertices.emplace_back(corner.x() * std::cos(angle), corner.x() * std::sin(angle),
                                 corner.y());
    }
  }
  for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring) {
    for (std::uint32_t i = 0; i < kSectors; ++i) {
      const std::uint32_t a = ring * kSectors + i;
      const std::uint32_t b = ring * kSectors + (i + 1) % kSectors;
      mesh.triangles.push_back({a, b, b + kSectors});
      mesh.triangles.push_back({a, b + kSectors, a + kSectors});
    }
  }
  return mesh;
}

/// A segment along z with a half circle at each end.
TriangleMesh turnedCapsule(double half_length, double radius) {
  Profile profile;
  for (const double end : {-half_length, half_length}) {
    const int first = end == -half_length && profile.empty() ? -kQuarter : 0;
    for (int i = first; i <= first + kQuarter; ++i) {
      const double angle = 0.5 * kPi * i / kQuarter;
      profile.emplace_back(radius * std::cos(angle), end + radius * std::sin(angle));
    }
  }
  return turned(profile);
}

struct Surface {
  TriangleMesh operator()(const Sphere& sphere) const { return turnedCapsule(0.0, sphere.radius); }
  TriangleMesh operator()(const Capsule& capsule) const {
    return turnedCapsule(capsule.half_length, capsule.radius);
  }
  TriangleMesh operator()(const Cylinder& cylinder) const {
    const double l = cylinder.half_length;
    const double r = cylinder.radius;
    return turned({{0.0, -l}, {r, -l}, {r, l}, {0.0, l}});
  }
  TriangleMesh operator()(const Box& box) const {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {  // bits of i: the sides along x, y, z
      const Eigen::Vector3d sides(i & 1, (i >> 1) & 1, i >> 2);
      mesh.vertices.push_back(
          (2.0 * sides - Eigen::Vector3d::Ones()).cwiseProduct(box.half_extents));
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
  }
  TriangleMesh operator()(const TriangleMesh& mesh) const { return mesh; }
};

}  // namespace

TriangleMesh surfaceMeshOf(const Geometry& geometry) { return std::visit(Surface(), geometry); }

TriangleMesh surfaceMeshOf(const Link& link, const std::vector<std::size_t>& elements) {
  TriangleMesh all;
  for (const std::size_t element : elements) {
    const CollisionElement& collision = link.collisions[element];
    const TriangleMesh mesh = surfaceMeshOf(collision.geometry);
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
      all.vertices.push_back(collision.link_from_geometry * vertex);
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      all.triangles.push_back({first + a, first + b, first + c});
    }
  }
  return all;
}

}  // namespace collision_monitor::fit_tool
