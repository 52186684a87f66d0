// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/sample_meshes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/constants.h"

namespace collision_monitor::test {
namespace {

using Index = std::uint32_t;

}  // namespace

TriangleMesh boxMesh(const Eigen::Vector3d& half_extents) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? half_extents.x() : -half_extents.x(),
                               (i & 2) != 0 ? half_extents.y() : -half_extents.y(),
                               (i & 4) != 0 ? half_extents.z() : -half_extents.z());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TriangleMesh boxMeshAt(const Eigen::Vector3d& half_extents, const Eigen::Vector3d& center) {
  return moved(boxMesh(half_extents), Eigen::Vector3d::Zero(), center);
}

TriangleMesh openBoxMesh(const Eigen::Vector3d& half_extents) {
  TriangleMesh mesh = boxMesh(half_extents);
  const auto isTop = [&](const auto& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](auto vertex) { return mesh.vertices[vertex].z() > 0.0; });
  };
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), isTop),
                       mesh.triangles.end());
  return mesh;
}

TriangleMesh prismMesh(double radius, double half_length, int sides) {
  TriangleMesh mesh;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * kPi * i / sides;
    const double x = radius * std::cos(angle);
    const double y = radius * std::sin(angle);
    mesh.vertices.emplace_back(x, y, -half_length);
    mesh.vertices.emplace_back(x, y, half_length);
  }
  const auto count = static_cast<Index>(2 * sides);
  for (Index low = 0; low < count; low += 2) {
    const Index next = (low + 2) % count;
    mesh.triangles.push_back({low, next, low + 1});
    mesh.triangles.push_back({next, next + 1, low + 1});
    if (low > 0 && next > 0) {
      mesh.triangles.push_back({0, next, low});
      mesh.triangles.push_back({1, low + 1, next + 1});
    }
  }
  return mesh;
}

TriangleMesh sphereMesh(double radius, int sectors) {
  TriangleMesh mesh;
  const int rings = sectors / 2;
  for (int ring = 0; ring <= rings; ++ring) {
    const double polar = kPi * ring / rings;
    for (int sector = 0; sector < sectors; ++sector) {
      const double azimuth = 2.0 * kPi * sector / sectors;
      mesh.vertices.emplace_back(radius * std::sin(polar) * std::cos(azimuth),
                                 radius * std::sin(polar) * std::sin(azimuth),
                                 radius * std::cos(polar));
    }
  }
  const auto at = [&](int ring, int sector) {
    return static_cast<Index>(ring * sectors + sector % sectors);
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      mesh.triangles.push_back({at(ring, sector), at(ring + 1, sector), at(ring, sector + 1)});
      mesh.triangles.push_back(
          {at(ring, sector + 1), at(ring + 1, sector), at(ring + 1, sector + 1)});
    }
  }
  return mesh;
}

TriangleMesh randomCloud(const Eigen::Vector3d& half_extents, int count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const double x = unit(generator);
    const double y = unit(generator);
    const double z = unit(generator);
    mesh.vertices.emplace_back(half_extents.cwiseProduct(Eigen::Vector3d(x, y, z)));
  }
  for (Index i = 2; i < static_cast<Index>(count); ++i) {
    mesh.triangles.push_back({i - 2, i - 1, i});
  }
  return mesh;
}

TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Vector3d& turn,
                   const Eigen::Vector3d& shift) {
  TriangleMesh result = mesh;
  const double angle = turn.norm();
  const Eigen::Matrix3d rotation = angle > 0.0
                                       ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                                       : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  for (auto& vertex : result.vertices) {
    vertex = rotation * vertex + shift;
  }
  return result;
}

TriangleMesh scaled(const TriangleMesh& mesh, double factor) {
  TriangleMesh result = mesh;
  for (auto& vertex : result.vertices) {
    vertex *= factor;
  }
  return result;
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) {
    a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return a;
}

}  // namespace collision_monitor::test
