// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "collision_monitor/fitting/inner_shape.h"
#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/model/shape_rules.h"
#include "collision_monitor/narrow_phase/convex_distance.h"

/// The second level of a cycle: elements, the geometries that enclosing shapes stand for. Elements
/// are measured where their shapes come near; see docs/architecture.md.
namespace collision_monitor {

/// Index into CycleSetup::elements.
enum class ElementId : std::uint32_t {};
using ElementPairIndex = std::uint32_t;  ///< into CycleSetup::element_pairs

/// What distances are refined to: a collision element of the URDF, or one enclosing shape where the
/// rules leave no geometry. `convex`, `mesh` or both are present.
struct Element {
  LinkId link{};                         ///< to which it is fixed
  std::string name;                      ///< its name in messages; never read in a cycle
  Pose link_from_element;                ///< where its geometry stands in the link
  std::optional<ConvexGeometry> convex;  ///< none: `mesh` alone says what it is
  /// A mesh. Beside `convex` it is a closed surface that holds `convex`, used for depths in meshes.
  /// Equal elements share it, and so do set-ups: it is large and takes long to make.
  std::shared_ptr<const MeshTree> mesh;
  std::optional<ConvexGeometry> hull;  ///< around `mesh`, where there is no `convex`
  double mesh_excess{0.0};             ///< [m] how far `mesh` may stick out of `convex`
  InnerShapes inner;                   ///< present only if is_exact
  double padding{0.0};                 ///< [m] to be subtracted from every distance
  bool is_exact{false};  ///< it is the geometry of the URDF, not something that encloses it
  bool is_body{false};   ///< it has one body, of the same shape and padding
};

/// Two elements of a checked link pair; the link of `a` comes before the link of `b`.
struct ElementPair {
  ElementId a{};               ///< of the first link
  ElementId b{};               ///< of the second link
  std::uint32_t link_pair{0};  ///< index into CycleSetup::checked
};

/// How much work a cycle spends on elements.
struct RefineLimits {
  /// [m] Elements are measured if their bodies are at most this far apart, or at most
  /// warning_distance + hysteresis of their pair.
  double distance{0.05};
  /// Work of one cycle: the number of node pairs opened; other work is converted. A continuous
  /// set-up leaves a quarter for sweepPairs. The budget grows where poses come seldom (budgetOf).
  /// It does not depend on the clock, so that the same input gives the same output.
  std::uint32_t budget{8000};
  /// [m] >= 0. How much less than the exact distance the distance of a mesh may be, as
  /// MeshQueryLimits::tolerance.
  double tolerance{0.0};
  /// [s] The time between two cycles. The budget grows no further than this time allows.
  double period{std::numeric_limits<double>::infinity()};
};

/// What distances are refined to, and how much work that may take.
struct RefineOptions {
  RefineGeometry geometry{RefineGeometry::mesh};  ///< where the rules say nothing
  RefineLimits limits;                            ///< of a cycle
};

}  // namespace collision_monitor
