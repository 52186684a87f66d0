// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/fits/open_meshes.h"

#include <cstdio>
#include <variant>

#include "collision_monitor/geometry/winding.h"
#include "fitting/proofs/closed_surface.h"
#include "narrow_phase/mesh_inside/mesh_openness.h"

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
  return Problem{"meshes",
                 "too open to tell well what is inside (0 is closed, 0.5 a sheet, from 0.05 on is "
                 "too open): " +
                     names_,
                 "",
                 "what such a surface surrounds in more than half of all directions counts as "
                 "inside it, and as contact; where that is wrong, mend the mesh, or take its "
                 "convex hull (refine: hull in a rule of shape_rules)"};
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
