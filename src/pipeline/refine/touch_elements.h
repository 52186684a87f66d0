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
    unknown,  ///< not told; the enclosing shapes know better
  };
  State state{State::unknown};
  std::uint32_t work{0};    ///< spent of the budget
  bool is_complete{false};  ///< false: a larger budget would have told more
  /// [m] as MeshDistance::outside
  double outside{std::numeric_limits<double>::infinity()};
};

struct ContactGoal {
  /// [m] Below 0 depths of convex elements are measured; all others overlap or not.
  double distance{0.0};
  bool asks_outside{false};  ///< ElementContact::outside is wanted, too
};

/// Whether two elements, less their paddings, come within a distance of each other: by the cheapest
/// question that tells. First the triangles that were in contact the last time, then hulls, inner
/// shapes and hierarchies of triangles, until one finds a contact or proves that there is none.
/// Nothing is measured.
///
/// Error: as contactOf and distanceByHulls.
ElementContact touchElements(const PlacedElement& a, const PlacedElement& b,
                             const ContactGoal& goal, ElementSearch& search) noexcept;

}  // namespace collision_monitor
