// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/distance_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double kNodes = 40000.0;
constexpr double kMargin = 0.15;  // of the longest side, on every side
constexpr int kMaxSteps = 128;    // along an edge, for samples on the surface
constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

}  // namespace

DistanceGrid::DistanceGrid(const TriangleMesh& mesh) {
  layOut(mesh);
  sampleSurface(mesh);
  markSurface();
  for (int signs = 0; signs < 8; ++signs) {
    sweep({(signs & 1) != 0 ? 1 : -1, (signs & 2) != 0 ? 1 : -1, (signs & 4) != 0 ? 1 : -1});
  }
  emptyInside();
}

void DistanceGrid::layOut(const TriangleMesh& mesh) {
  Vector3d low = mesh.vertices.front();
  Vector3d high = low;
  for (const auto& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  const Vector3d margin = Vector3d::Constant(kMargin * (high - low).maxCoeff());
  low_ = low - margin;
  const Vector3d extent = high - low + 2.0 * margin;
  spacing_ = std::cbrt(extent.prod() / kNodes);
  nodes_per_metre_ = spacing_ > 0.0 ? 1.0 / spacing_ : 0.0;
  for (int k = 0; k < 3; ++k) {
    size_[static_cast<std::size_t>(k)] =
        spacing_ > 0.0 ? 2 + static_cast<int>(extent[k] / spacing_) : 2;
  }
}

/// Samples every triangle on a lattice, no coarser than the grid.
void DistanceGrid::sampleSurface(const TriangleMesh& mesh) {
  surface_ = mesh.vertices;
  if (!(spacing_ > 0.0)) {
    return;  // all points coincide
  }
  for (const auto& triangle : mesh.triangles) {
    throwIfInterrupted();
    const Vector3d& a = mesh.vertices[triangle[0]];
    const Vector3d along_b = mesh.vertices[triangle[1]] - a;
    const Vector3d along_c = mesh.vertices[triangle[2]] - a;
    const double longest = std::max({along_b.norm(), along_c.norm(), (along_c - along_b).norm()});
    const int steps = std::clamp(static_cast<int>(std::ceil(longest / spacing_)), 1, kMaxSteps);
    if (steps < 2) {
      continue;  // its corners suffice
    }
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps - i; ++j) {
        surface_.emplace_back(a + (static_cast<double>(i) / steps) * along_b +
                              (static_cast<double>(j) / steps) * along_c);
      }
    }
  }
}

/// Marks the node nearest to each point of the surface. The sweeps reach all other nodes.
void DistanceGrid::markSurface() {
  const std::size_t count = indexOf(size_[0] - 1, size_[1] - 1, size_[2] - 1) + 1;
  for (std::size_t k = 0; k < 3; ++k) {
    last_[static_cast<Eigen::Index>(k)] = static_cast<float>(size_[k]) - 1.001f;
  }
  nearest_.assign(count, kNone);
  distance_.assign(count, kFloatInfinity);
  for (std::uint32_t i = 0; i < surface_.size(); ++i) {
    throwIfInterrupted();
    Vector3i cell = Vector3i::Zero();
    if (spacing_ > 0.0) {
      cell = ((surface_[i] - low_) * nodes_per_metre_ + Vector3d::Constant(0.5)).cast<int>();
    }
    takeNearer(i, indexOf(cell.x(), cell.y(), cell.z()), nodeAt(cell.x(), cell.y(), cell.z()));
  }
}

void DistanceGrid::takeNearer(std::uint32_t point, std::size_t node, const Vector3d& at) {
  const Vector3d offset = (at - surface_[point]) * nodes_per_metre_;
  const auto squared = static_cast<float>(offset.squaredNorm());
  if (squared < distance_[node]) {
    distance_[node] = squared;
    nearest_[node] = point;
  }
}

/// Takes over nearest points from the three neighbours that were visited before.
void DistanceGrid::sweep(const Vector3i& direction) {
  const Vector3i size(size_[0], size_[1], size_[2]);
  const std::array<std::ptrdiff_t, 3> back{
      -direction.x(), -direction.y() * static_cast<std::ptrdiff_t>(size.x()),
      -direction.z() * static_cast<std::ptrdiff_t>(size.x()) * size.y()};
  const Vector3i first = (direction.array() > 0).select(Vector3i::Zero(), size.array() - 1);
  Vector3i here;
  for (here.z() = first.z(); here.z() >= 0 && here.z() < size.z(); here.z() += direction.z()) {
    throwIfInterrupted();
    for (here.y() = first.y(); here.y() >= 0 && here.y() < size.y(); here.y() += direction.y()) {
      for (here.x() = first.x(); here.x() >= 0 && here.x() < size.x(); here.x() += direction.x()) {
        const std::size_t node = indexOf(here.x(), here.y(), here.z());
        for (int k = 0; k < 3; ++k) {
          if (here[k] == first[k]) {
            continue;
          }
          const auto before = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) +
                                                       back[static_cast<std::size_t>(k)]);
          if (nearest_[before] != kNone && nearest_[before] != nearest_[node]) {
            takeNearer(nearest_[before], node, nodeAt(here.x(), here.y(), here.z()));
          }
        }
      }
    }
  }
}

Points DistanceGrid::surface() const {
  std::vector<std::uint32_t> chosen;
  for (int z = 0; z < size_[2]; ++z) {
    for (int y = 0; y < size_[1]; ++y) {
      for (int x = 0; x < size_[0]; ++x) {
        const std::uint32_t nearest = nearest_[indexOf(x, y, z)];
        const Vector3d offset = nodeAt(x, y, z) - surface_[nearest];
        if (offset.cwiseAbs().maxCoeff() <= 0.5 * spacing_) {
          chosen.push_back(nearest);
        }
      }
    }
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  Points points;
  for (const auto i : chosen) {
    points.push_back(surface_[i]);
  }
  return points;
}

/// Turns squares into distances, and into 0 at nodes that no path from outside reaches.
void DistanceGrid::emptyInside() {
  constexpr float kWall = 0.75f;  // half a cell's diagonal, squared
  std::vector<unsigned char> reached(distance_.size(), 0);
  std::vector<Vector3i> open;
  const auto visit = [&](const Vector3i& at) {
    const std::size_t node = indexOf(at.x(), at.y(), at.z());
    if (reached[node] == 0) {
      reached[node] = 1;
      if (distance_[node] > kWall) {
        open.push_back(at);
      }
    }
  };
  // The margin is wider than a wall, so one corner reaches the whole outside.
  visit(Vector3i::Zero());
  while (!open.empty()) {
    const Vector3i here = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k) {
      for (const int step : {-1, 1}) {
        Vector3i next = here;
        next[k] += step;
        if (next[k] >= 0 && next[k] < size_[static_cast<std::size_t>(k)]) {
          visit(next);
        }
      }
    }
  }
  for (std::size_t node = 0; node < distance_.size(); ++node) {
    distance_[node] = reached[node] != 0 ? std::sqrt(distance_[node]) : 0.0f;
  }
}

}  // namespace collision_monitor
