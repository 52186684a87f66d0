// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/refine/measure_elements.h"

namespace collision_monitor {

/// Whether two elements are in contact.
struct ElementContact {
  enum class State : unsigned char {
    apart,
    contact,
    unknown,  ///< not decided; enclosing shapes give the bound
  };
  State state{State::unknown};
  std::uint32_t work{0};    ///< work done of the budget
  bool is_complete{false};  ///< false: a larger budget would have found more
  /// [m] as MeshDistance::outside
  double outside{std::numeric_limits<double>::infinity()};
};

struct ContactGoal {
  /// [m] If < 0, depths of convex elements are measured; other elements overlap or do not.
  double distance{0.0};
  bool asks_outside{false};     ///< ElementContact::outside is needed, too
  double outside{0.0};          ///< [m] as MeshContactQuery::outside
  bool is_measured_next{true};  ///< as HullGoal::asks_nearest: what hulls find serves the measuring
};

/// Contact within a distance, and nothing beside it.
inline ContactGoal contactAlone(double distance) noexcept { return {distance, false, 0.0, false}; }

/// Decides whether two padded elements are within a distance of each other, by the cheapest test
/// that decides it: hulls, then inner shapes, then hierarchies of triangles. Where few triangles
/// found the last contacts, some are asked first. Measures nothing.
///
/// Error: as contactOf and distanceByHulls.
ElementContact touchElements(const PlacedElement& a, const PlacedElement& b,
                             const ContactGoal& goal, ElementSearch& search) noexcept;

}  // namespace collision_monitor
