// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "collision_monitor/pipeline/setup.h"

namespace collision_monitor {

/// [m] At or below this distance elements are in contact. Overlapping concave geometries are in
/// contact at any depth, since their depth is an estimate; where only their padding overlaps, its
/// depth is known.
inline double contactOfElements(const CycleSetup& setup, ElementPairIndex pair) noexcept {
  const ElementPair& elements = setup.element_pairs[pair];
  const Element& a = setup.elements[index(elements.a)];
  const Element& b = setup.elements[index(elements.b)];
  const double contact = limitsOf(setup, elements.link_pair).contact_distance;
  return a.convex && b.convex ? contact : std::max(-(a.padding + b.padding), contact);
}

/// [m] At or below this distance bodies may represent a contact of their elements.
///
/// If contact_distance allows some depth, the depth of bodies says nothing of their elements: a
/// body that is one of several around an element is less deep than the element, and overlapping
/// concave geometries are in contact at any depth.
inline double contactOfBodies(const CycleSetup& setup, PairId pair) noexcept {
  const ElementPair& elements = setup.element_pairs[setup.element_pair_of[index(pair)]];
  const double contact = limitsOf(setup, elements.link_pair).contact_distance;
  const bool are_elements =
      setup.elements[index(elements.a)].is_body && setup.elements[index(elements.b)].is_body;
  return are_elements ? contact : std::max(0.0, contact);
}

/// For findContact of pair_blocks.h.
inline ContactDistances contactDistancesOf(const CycleSetup& setup) {
  ContactDistances limits;
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    limits.of_pair.push_back(contactOfBodies(setup, idAt<PairId>(i)));
    limits.largest = std::max(limits.largest, limits.of_pair.back());
  }
  return limits;
}

}  // namespace collision_monitor
