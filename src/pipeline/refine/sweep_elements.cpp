// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/sweep_elements.h"

#include "narrow_phase/closed_form/core_distance.h"
#include "pipeline/refine/element_parts.h"

namespace collision_monitor {
namespace {

/// Work of one distance of convex geometries, in opened node pairs.
constexpr std::uint32_t kConvexWork = 8;

bool isPlane(const Element& element) noexcept {
  return element.convex && std::holds_alternative<HalfSpace>(*element.convex);
}

/// A mesh meets a plane where its hull does.
bool areConvex(const Element& a, const Element& b) noexcept {
  return (a.convex && b.convex) || isPlane(a) || isPlane(b);
}

/// @pre areConvex
SweptContact sweepConvex(const MovingElement& a, const MovingElement& b, SweepLimits limits,
                         RefineScratch& scratch) noexcept {
  ConvexWarmStart warm;
  ConvexSearch search{scratch.convex, warm};
  limits.budget = limits.budget / kConvexWork + (limits.budget % kConvexWork == 0 ? 0 : 1);
  SweptContact found =
      firstContact(MovingConvex{hullOf(a.element), a.ball, a.motion},
                   MovingConvex{hullOf(b.element), b.ball, b.motion}, limits, search);
  found.work *= kConvexWork;
  return found;
}

SweptContact sweepMeshes(const MovingElement& a, const MovingElement& b, const SweepLimits& limits,
                         RefineScratch& scratch) noexcept {
  const auto mesh_of = [](const MovingElement& moving) noexcept {
    return MovingMesh{*moving.element.mesh, moving.motion};
  };
  const std::optional<Shape> shape_a = shapeOf(a.element.convex);
  const std::optional<Shape> shape_b = shapeOf(b.element.convex);
  if (shape_b) {
    return firstContact(mesh_of(a), MovingShape{*shape_b, b.motion}, limits, scratch.mesh);
  }
  if (shape_a) {
    SweptContact found =
        firstContact(mesh_of(b), MovingShape{*shape_a, a.motion}, limits, scratch.mesh);
    found.measured = swapped(found.measured);
    return found;
  }
  return firstContact(mesh_of(a), mesh_of(b), limits, scratch.mesh);
}

}  // namespace

SweptContact sweepElements(const MovingElement& a, const MovingElement& b,
                           const SweepLimits& limits, RefineScratch& scratch) noexcept {
  SweepLimits unpadded = limits;
  unpadded.contact_distance += a.element.padding + b.element.padding;
  const bool are_convex = areConvex(a.element, b.element);
  SweptContact found =
      are_convex ? sweepConvex(a, b, unpadded, scratch) : sweepMeshes(a, b, unpadded, scratch);
  const double excess = are_convex ? 0.0 : a.element.mesh_excess + b.element.mesh_excess;
  if (found.state == SweepState::contact && excess > 0.0) {
    found.state = SweepState::undecided;
  }
  found.measured = inflated(found.measured, a.element.padding, b.element.padding);
  return found;
}

}  // namespace collision_monitor
