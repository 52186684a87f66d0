// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/fits/fill_hollow.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <variant>

#include "collision_monitor/geometry/triangle_bvh.h"
#include "fitting/proofs/closed_surface.h"
#include "narrow_phase/distance.h"
#include "narrow_phase/mesh_inside/mesh_inside.h"
#include "narrow_phase/mesh_inside/mesh_openness.h"
#include "pipeline/fits/open_meshes.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr double kCells = 20.0;  // cells along the longest side

bool isInShapes(const Vector3d& point, const Fit& fit) {
  const Shape mark = Sphere{0.0};
  const Pose place{Eigen::Matrix3d::Identity(), point};
  return std::any_of(fit.shapes.begin(), fit.shapes.end(), [&](const Enclosure& enclosure) {
    return distanceBetween(enclosure.shape, enclosure.geometry_from_body, mark, place).distance <=
           0.0;
  });
}

void addCorners(const Vector3d& center, double half, TriangleMesh& cells) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d side((corner & 1) != 0 ? half : -half, (corner & 2) != 0 ? half : -half,
                        (corner & 4) != 0 ? half : -half);
    cells.vertices.push_back(center + side);
  }
}

/// The corners of cells whose center is inside the mesh and in none of the shapes.
TriangleMesh hollowOf(const TriangleMesh& mesh, const MeshTree& tree, const Fit& fit) {
  const Aabb box = TriangleBvh(mesh).bounds();
  const Vector3d size = box.max - box.min;
  const double cell = size.maxCoeff() / kCells;
  const auto memory = std::make_unique<MeshQueryMemory>();
  TriangleMesh cells;
  for (double x = 0.5 * cell; x < size.x(); x += cell) {
    for (double y = 0.5 * cell; y < size.y(); y += cell) {
      for (double z = 0.5 * cell; z < size.z(); z += cell) {
        const Vector3d center = box.min + Vector3d(x, y, z);
        if (!isInShapes(center, fit) && lookInside(tree, center, *memory, false).is_inside) {
          addCorners(center, 0.5 * cell, cells);
        }
      }
    }
  }
  return cells;
}

}  // namespace

void fillHollow(const Geometry& geometry, const ShapeKinds& kinds, Fit& fit) {
  const auto* mesh = std::get_if<TriangleMesh>(&geometry);
  if (mesh == nullptr || mesh->triangles.empty() || closedSurface(*mesh)) {
    return;
  }
  const MeshTree tree = treeOfOpen(*mesh);
  fit.openness = opennessOf(tree);
  if (fit.shapes.size() < 2) {
    return;
  }
  const TriangleMesh hollow = hollowOf(*mesh, tree, fit);
  if (hollow.vertices.empty()) {
    return;
  }
  if (fit.shape_of.empty()) {
    fit.shape_of.resize(fit.shapes.size());
    std::iota(fit.shape_of.begin(), fit.shape_of.end(), 0U);
  }
  fit.shapes.push_back(encloseTightly(hollow, kinds));
}

}  // namespace collision_monitor
