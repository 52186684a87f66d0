// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "collision_monitor/pipeline/setup.h"

namespace collision_monitor {

/// [m] At this distance or nearer elements are in contact: concave ones that overlap are, however
/// deep, for that is an estimate.
inline double contactOfElements(const CycleSetup& setup, ElementPairIndex pair) noexcept {
  const ElementPair& elements = setup.element_pairs[pair];
  const double contact = setup.limits.contact_distance;
  const bool are_convex =
      setup.elements[index(elements.a)].convex && setup.elements[index(elements.b)].convex;
  return are_convex ? contact : std::max(0.0, contact);
}

/// [m] At this distance or nearer bodies may stand for a contact of their elements.
///
/// Where contact_distance allows some depth, that of bodies says nothing of what they enclose: one
/// of several about an element is less deep than the element, and concave geometries that overlap
/// are in contact however deep.
inline double contactOfBodies(const CycleSetup& setup, PairId pair) noexcept {
  const double contact = setup.limits.contact_distance;
  const ElementPair& elements = setup.element_pairs[setup.element_pair_of[index(pair)]];
  const bool are_elements =
      setup.elements[index(elements.a)].is_body && setup.elements[index(elements.b)].is_body;
  return are_elements ? contact : std::max(0.0, contact);
}

}  // namespace collision_monitor
