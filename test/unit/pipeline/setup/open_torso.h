// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "support/robots/geometry_setup.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test::open_meshes {

/// A torso of 0.6 m with four holes of one triangle: twelve edges are open.
inline TriangleMesh torso() {
  TriangleMesh mesh = sphereMesh(0.3, 24);
  for (const std::size_t hole : {500, 400, 300, 100}) {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(hole));
  }
  return mesh;
}

/// Open above, 0.4 m wide.
inline TriangleMesh bin() {
  TriangleMesh mesh = boxMesh({0.2, 0.2, 0.2});
  TriangleMesh open{mesh.vertices, {}};
  for (const auto& t : mesh.triangles) {
    const double height =
        mesh.vertices[t[0]].z() + mesh.vertices[t[1]].z() + mesh.vertices[t[2]].z();
    if (height < 0.55) {
      open.triangles.push_back(t);
    }
  }
  return open;
}

/// A forearm that no convex geometry stands for.
inline TriangleMesh forearm() {
  return moved(scaled(angleMesh(), 0.2), Eigen::Vector3d::Zero(), {-0.02, -0.02, 0});
}

}  // namespace collision_monitor::test::open_meshes
