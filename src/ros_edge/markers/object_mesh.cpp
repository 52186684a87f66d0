// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/object_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <utility>
#include <variant>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/geometry/ids.h"
#include "geometry/all_cores.h"
#include "geometry/constants.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

constexpr std::size_t kMostCells = 64;  ///< along each axis

/// The cell of a vertex in a grid of cubes from `least` on.
std::size_t cellOf(const Eigen::Vector3d& vertex, const Eigen::Vector3d& least, double cell,
                   std::size_t cells) {
  std::size_t place = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto along = static_cast<std::size_t>((vertex[axis] - least[axis]) / cell);
    place = place * cells + std::min(along, cells - 1);
  }
  return place;
}

/// A key of a triangle, whichever corner comes first and however it turns.
std::uint64_t keyOf(std::array<std::uint32_t, 3> corners) {
  static_assert(kMostCells * kMostCells * kMostCells < (1U << 21U));
  std::sort(corners.begin(), corners.end());
  return (std::uint64_t{corners[0]} << 42U) | (std::uint64_t{corners[1]} << 21U) | corners[2];
}

/// One vertex for each cell that has any, and the triangles that do not collapse; none if these are
/// more than `most`.
std::optional<TriangleMesh> clustered(const TriangleMesh& mesh, const Aabb& box, std::size_t cells,
                                      std::size_t most) {
  const double cell = (box.max - box.min).maxCoeff() / static_cast<double>(cells);
  TriangleMesh coarse;
  std::vector<std::uint32_t> vertex_of(cells * cells * cells, kNone);
  std::vector<std::uint32_t> new_of;
  new_of.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    std::uint32_t& known = vertex_of[cellOf(vertex, box.min, cell, cells)];
    if (known == kNone) {
      known = static_cast<std::uint32_t>(coarse.vertices.size());
      coarse.vertices.push_back(vertex);
    }
    new_of.push_back(known);
  }
  std::unordered_set<std::uint64_t> seen;
  for (const auto& t : mesh.triangles) {
    const std::array<std::uint32_t, 3> corners{new_of[t[0]], new_of[t[1]], new_of[t[2]]};
    const bool is_flat =
        corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
    if (!is_flat && seen.insert(keyOf(corners)).second) {
      if (coarse.triangles.size() == most) {
        return std::nullopt;
      }
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
  Aabb box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    box.min = box.min.cwiseMin(vertex);
    box.max = box.max.cwiseMax(vertex);
  }
  const bool has_size = (box.max - box.min).maxCoeff() > 0.0;
  for (std::size_t cells = has_size ? kMostCells : 0; cells > 0; cells = cells * 7 / 10) {
    if (std::optional<TriangleMesh> coarse = clustered(mesh, box, cells, most)) {
      return *std::move(coarse);
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
