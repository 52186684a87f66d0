// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/object_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

#include "geometry/all_cores.h"
#include "geometry/constants.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

using Cell = std::tuple<int, int, int>;

/// One vertex for each cell that has any, and the triangles that do not collapse.
TriangleMesh clustered(const TriangleMesh& mesh, double cell) {
  TriangleMesh coarse;
  std::map<Cell, std::uint32_t> vertex_of;
  std::vector<std::uint32_t> new_of;
  new_of.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const Eigen::Vector3i place = (vertex / cell).array().floor().cast<int>();
    const auto [known, is_new] = vertex_of.emplace(
        Cell(place.x(), place.y(), place.z()), static_cast<std::uint32_t>(coarse.vertices.size()));
    if (is_new) {
      coarse.vertices.push_back(vertex);
    }
    new_of.push_back(known->second);
  }
  std::set<std::array<std::uint32_t, 3>> seen;
  for (const auto& triangle : mesh.triangles) {
    const std::array<std::uint32_t, 3> corners{new_of[triangle[0]], new_of[triangle[1]],
                                               new_of[triangle[2]]};
    std::array<std::uint32_t, 3> sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    const bool is_flat = sorted[0] == sorted[1] || sorted[1] == sorted[2];
    if (!is_flat && seen.insert(sorted).second) {
      coarse.triangles.push_back(corners);
    }
  }
  return coarse;
}

/// Calls `use` with each mesh; with one that stands in several places, for each of them.
template <class Use>
void forMeshes(const World& world, const Use& use) {
  for (const auto& named : world.objects) {
    for (const ObjectShape& shape : *named.second->shapes) {
      if (const auto* mesh = std::get_if<SharedMesh>(&shape.geometry)) {
        use(*mesh);
      }
    }
  }
}

/// The most triangles of each mesh. Halved again and again, so that it seldom changes.
std::size_t shareOf(const World& world) {
  for (std::size_t share = kMostDrawn; share > 0; share /= 2) {
    std::size_t all = 0;
    forMeshes(world,
              [&](const SharedMesh& mesh) { all += std::min(mesh->triangles.size(), share); });
    if (all <= kMostDrawnOfAll) {
      return share;
    }
  }
  return 0;
}

SharedMesh coarser(const SharedMesh& mesh, std::size_t most) {
  constexpr std::size_t kLeast = 50;  // fewer show no shape
  return mesh->triangles.size() <= most
             ? mesh
             : std::make_shared<const TriangleMesh>(most < kLeast ? TriangleMesh()
                                                                  : coarseMesh(*mesh, most));
}

}  // namespace

TriangleMesh surfaceOf(const Cone& cone) {
  constexpr std::uint32_t kSides = 32;
  TriangleMesh mesh;
  mesh.vertices = {{0.0, 0.0, cone.half_length}, {0.0, 0.0, -cone.half_length}};
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2.0 * kPi * i / kSides;
    mesh.vertices.emplace_back(cone.radius * std::cos(angle), cone.radius * std::sin(angle),
                               -cone.half_length);
    const std::uint32_t here = 2 + i;
    const std::uint32_t next = 2 + (i + 1) % kSides;
    mesh.triangles.push_back({0, here, next});
    mesh.triangles.push_back({1, next, here});
  }
  return mesh;
}

TriangleMesh coarseMesh(const TriangleMesh& mesh, std::size_t most) {
  if (mesh.triangles.size() <= most) {
    return mesh;
  }
  Eigen::Vector3d least = mesh.vertices.front();
  Eigen::Vector3d largest = mesh.vertices.front();
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    least = least.cwiseMin(vertex);
    largest = largest.cwiseMax(vertex);
  }
  const double size = (largest - least).maxCoeff();
  for (double cells = 64.0; cells >= 1.0; cells *= 0.7) {
    TriangleMesh coarse = clustered(mesh, size / cells);
    if (coarse.triangles.size() <= most) {
      return coarse;
    }
  }
  return {};
}

DrawnMeshes drawMeshes(const World& world, const DrawnMeshes& former) {
  const std::size_t share = shareOf(world);
  DrawnMeshes all;
  std::vector<std::pair<const SharedMesh*, DrawnMesh*>> changed;
  forMeshes(world, [&](const SharedMesh& mesh) {
    const auto [place, is_new] = all.try_emplace(mesh);
    if (is_new) {
      const auto known = former.find(mesh);
      place->second = known == former.end() ? DrawnMesh() : known->second;
      if (place->second.most != share || place->second.drawn == nullptr) {
        changed.emplace_back(&place->first, &place->second);
      }
    }
  });
  forEachOnAllCores(changed.size(), [&](std::size_t i) {
    throwIfInterrupted();
    DrawnMesh& mesh = *changed[i].second;
    mesh.fine = mesh.fine == nullptr ? coarser(*changed[i].first, kMostDrawn) : mesh.fine;
    mesh.drawn = coarser(mesh.fine, share);
    mesh.most = share;
  });
  return all;
}

}  // namespace collision_monitor
