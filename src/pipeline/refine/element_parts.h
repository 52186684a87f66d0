// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh/mesh_hulls.h"
#include "pipeline/refine/measure_elements.h"

/// The parts of an element that are measured.
namespace collision_monitor {

inline PlacedMesh meshOf(const PlacedElement& placed) noexcept {
  return {*placed.element.mesh, placed.world_from_element};
}

/// Whether the solid is cheaper to measure than triangles around it. A hull is not.
inline bool isSimple(const PlacedElement& placed) noexcept {
  const std::optional<ConvexGeometry>& convex = placed.element.convex;
  return convex && !std::holds_alternative<ConvexHull>(*convex);
}

inline PlacedConvex convexOf(const PlacedElement& placed) noexcept {
  return {*placed.element.convex, placed.world_from_element};
}

/// The convex solid, or the hull around the mesh.
inline const ConvexGeometry& hullOf(const Element& element) noexcept {
  return element.convex ? *element.convex : *element.hull;
}

/// The convex solid, or the mesh with the hull that holds it.
inline HeldSurface heldSurfaceOf(const PlacedElement& placed) noexcept {
  const Element& element = placed.element;
  return element.convex ? HeldSurface{*element.convex, nullptr, placed.world_from_element}
                        : HeldSurface{*element.hull, &*element.mesh, placed.world_from_element};
}

/// Finds the least signed distance of the inner shapes; false if an element has none.
bool measureInside(const PlacedElement& a, const PlacedElement& b, SignedDistance& least) noexcept;

}  // namespace collision_monitor
