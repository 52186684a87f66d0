// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/open_meshes.h"

#include <cstdio>
#include <variant>

#include "collision_monitor/geometry/winding.h"
#include "collision_monitor/narrow_phase/mesh_openness.h"
#include "fitting/closed_surface.h"

namespace collision_monitor {

MeshTree treeOfOpen(const TriangleMesh& mesh) {
  const TriangleMesh oriented = orientedSurface(mesh);
  return closedSurface(oriented) ? MeshTree(oriented, true) : MeshTree::ofOriented(oriented);
}

void OpenMeshes::look(const std::string& link, const std::string& collision, double openness) {
  if (openness >= kTooOpen) {
    char number[16];
    std::snprintf(number, sizeof(number), "%.2f", openness);
    names_ += (names_.empty() ? "" : ", ") + link + " (" + collision + ": " + number + ")";
  }
}

std::optional<Problem> OpenMeshes::warning() const {
  if (names_.empty()) {
    return std::nullopt;
  }
  return Problem{"refinement", "meshes so open that their inside is a convention: " + names_,
                 "openness below 0.05 (0 is closed, 0.5 a sheet); in these, contact is also "
                 "wherever the surface covers more than half of all directions, and refine: hull "
                 "in a rule closes them"};
}

std::optional<Problem> warnOfOpenMeshes(const RobotModel& model) {
  OpenMeshes open;
  for (const Link& link : model.links) {
    for (const CollisionElement& collision : link.collisions) {
      const auto* mesh = std::get_if<TriangleMesh>(&collision.geometry);
      if (mesh != nullptr && !closedSurface(*mesh)) {
        open.look(link.name, collision.name, opennessOf(treeOfOpen(*mesh)));
      }
    }
  }
  return open.warning();
}

}  // namespace collision_monitor
