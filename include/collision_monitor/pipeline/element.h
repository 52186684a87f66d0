// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "collision_monitor/fitting/inner_shape.h"
#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/model/shape_rules.h"
#include "collision_monitor/narrow_phase/convex_distance.h"

/// The second level of a cycle: what stands behind the enclosing shapes, to be measured where they
/// come near. docs/architecture.md says how the two levels meet.
namespace collision_monitor {

enum class ElementId : std::uint32_t {};
using ElementPairIndex = std::uint32_t;  ///< into CycleSetup::element_pairs

/// A collision element of the URDF as distances are refined to; or one enclosing shape, where no
/// geometry stands behind it. `convex`, `mesh` or both are there.
struct Element {
  LinkId link{};
  std::string name;  ///< as messages call it; never read in a cycle
  Pose link_from_element;
  std::optional<ConvexGeometry> convex;
  /// A mesh. Beside `convex`, a closed surface that holds it, for how deep it is in a mesh.
  std::optional<MeshTree> mesh;
  std::optional<ConvexGeometry> hull;  ///< around `mesh`, where there is no `convex`
  double mesh_excess{0.0};             ///< [m] how far `mesh` may stick out of `convex`
  InnerShapes inner;                   ///< of what is_exact; none otherwise
  double padding{0.0};                 ///< [m] to be taken off every distance
  bool is_exact{false};                ///< the geometry of the URDF, not something that encloses it
  bool is_body{false};                 ///< it has one body, which has the same shape and padding
};

/// Two elements of a checked pair of links, a's link before b's.
struct ElementPair {
  ElementId a{};
  ElementId b{};
  std::uint32_t link_pair{0};  ///< index into CycleSetup::checked
};

/// How much a cycle refines.
struct RefineLimits {
  /// [m] Pairs whose enclosing shapes are this near, or nearer. Raised to where verdicts are made:
  /// warning_distance + hysteresis.
  double distance{0.05};
  /// Nodes of hierarchies opened in one cycle; other work is converted. A quarter is left to what
  /// happens between two cycles, if that is looked at. Where poses come seldom it grows: budgetOf.
  /// Independent of the clock, so that the same input gives the same output.
  std::uint32_t budget{8000};
  /// [m] 0 or more: how much less than the exact one the distance of a mesh may be, as
  /// MeshQueryLimits::tolerance.
  double tolerance{0.0};
  /// [s] There is no more time for a cycle than that, however seldom poses come.
  double period{std::numeric_limits<double>::infinity()};
};

struct RefineOptions {
  RefineGeometry geometry{RefineGeometry::mesh};  ///< where the rules say nothing else
  RefineLimits limits;
};

}  // namespace collision_monitor
