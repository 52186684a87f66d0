// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/distance_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double kNodes = 40000.0;
constexpr double kMargin = 0.15;  // of the longest side, on every side
constexpr int kMaxSteps = 128;    // along an edge, of samples on the surface
constexpr std::uint32_t kNone = 0xffffffffU;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

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
  for (int k = 0; k < 3; ++k) {
    size_[static_cast<std::size_t>(k)] =
        spacing_ > 0.0 ? 2 + static_cast<int>(extent[k] / spacing_) : 2;
  }
}

/// A lattice on every triangle, no coarser than the grid.
void DistanceGrid::sampleSurface(const TriangleMesh& mesh) {
  surface_ = mesh.vertices;
  if (!(spacing_ > 0.0)) {
    return;  // all in one place
  }
  for (const auto& triangle : mesh.triangles) {
    const Vector3d& a = mesh.vertices[triangle[0]];
    const Vector3d along_b = mesh.vertices[triangle[1]] - a;
    const Vector3d along_c = mesh.vertices[triangle[2]] - a;
    const double longest = std::max({along_b.norm(), along_c.norm(), (along_c - along_b).norm()});
    const int steps = std::clamp(static_cast<int>(std::ceil(longest / spacing_)), 1, kMaxSteps);
    if (steps < 2) {
      continue;  // its corners say it all
    }
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps - i; ++j) {
        surface_.emplace_back(a + (static_cast<double>(i) / steps) * along_b +
                              (static_cast<double>(j) / steps) * along_c);
      }
    }
  }
}

/// The nodes around each point of the surface.
void DistanceGrid::markSurface() {
  const std::size_t count = indexOf(size_[0] - 1, size_[1] - 1, size_[2] - 1) + 1;
  last_ = Vector3d(size_[0] - 1.001, size_[1] - 1.001, size_[2] - 1.001);
  nearest_.assign(count, kNone);
  distance_.assign(count, kInfinity);
  for (std::uint32_t i = 0; i < surface_.size(); ++i) {
    const Vector3i cell = spacing_ > 0.0 ? Vector3i(((surface_[i] - low_) / spacing_).cast<int>())
                                         : Vector3i(Vector3i::Zero());
    for (int corner = 0; corner < 8; ++corner) {
      const int x = cell.x() + (corner & 1);
      const int y = cell.y() + (corner >> 1 & 1);
      const int z = cell.z() + (corner >> 2);
      if (x >= size_[0] || y >= size_[1] || z >= size_[2]) {
        continue;
      }
      const double squared = (nodeAt(x, y, z) - surface_[i]).squaredNorm();
      const std::size_t node = indexOf(x, y, z);
      if (squared < distance_[node]) {
        distance_[node] = squared;
        nearest_[node] = i;
      }
    }
  }
}

void DistanceGrid::takeNearer(const Vector3i& from, const Vector3i& to) {
  const std::size_t source = indexOf(from.x(), from.y(), from.z());
  const std::size_t node = indexOf(to.x(), to.y(), to.z());
  if (nearest_[source] == kNone || nearest_[source] == nearest_[node]) {
    return;
  }
  const double squared =
      (nodeAt(to.x(), to.y(), to.z()) - surface_[nearest_[source]]).squaredNorm();
  if (squared < distance_[node]) {
    distance_[node] = squared;
    nearest_[node] = nearest_[source];
  }
}

void DistanceGrid::sweep(const Vector3i& direction) {
  const auto first = [&](int k) {
    return direction[k] > 0 ? 0 : size_[static_cast<std::size_t>(k)] - 1;
  };
  const auto inside = [&](int k, int i) {
    return i >= 0 && i < size_[static_cast<std::size_t>(k)];
  };
  for (int z = first(2); inside(2, z); z += direction.z()) {
    for (int y = first(1); inside(1, y); y += direction.y()) {
      for (int x = first(0); inside(0, x); x += direction.x()) {
        const Vector3i here(x, y, z);
        for (int k = 0; k < 3; ++k) {
          Vector3i before = here;
          before[k] -= direction[k];
          if (inside(k, before[k])) {
            takeNearer(before, here);
          }
        }
      }
    }
  }
}

Points DistanceGrid::surface() const {
  std::vector<std::uint32_t> chosen;
  for (std::size_t node = 0; node < distance_.size(); ++node) {
    const Vector3d& nearest = surface_[nearest_[node]];
    const auto z = static_cast<int>(node) / (size_[0] * size_[1]);
    const auto y = static_cast<int>(node) / size_[0] % size_[1];
    const auto x = static_cast<int>(node) % size_[0];
    if ((nodeAt(x, y, z) - nearest).cwiseAbs().maxCoeff() <= 0.5 * spacing_) {
      chosen.push_back(nearest_[node]);
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

/// Turns squares into distances, and into 0 where no way from without leads.
void DistanceGrid::emptyInside() {
  const double wall = 0.75 * spacing_ * spacing_;  // half a cell's diagonal, squared
  std::vector<unsigned char> reached(distance_.size(), 0);
  std::vector<Vector3i> open;
  const auto visit = [&](const Vector3i& at) {
    const std::size_t node = indexOf(at.x(), at.y(), at.z());
    if (reached[node] == 0) {
      reached[node] = 1;
      if (distance_[node] > wall) {
        open.push_back(at);
      }
    }
  };
  // The margin is wider than a wall, so one corner reaches all that is without.
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
    distance_[node] = reached[node] != 0 ? std::sqrt(distance_[node]) : 0.0;
  }
}

}  // namespace collision_monitor
