// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/constants.h"
#include "pipeline/blocks/contact_of_pairs.h"
#include "pipeline/states/state_elements.h"

namespace collision_monitor {

void putFirst(ElementPairIndex pair, std::vector<OrderedPair>& order) noexcept {
  const auto place = std::find_if(order.begin(), order.end(),
                                  [&](const OrderedPair& one) { return one.elements == pair; });
  std::rotate(order.begin(), place, place + 1);
}

bool areBodies(const CycleSetup& setup, ElementPairIndex pair) noexcept {
  const ElementPair& elements = setup.element_pairs[pair];
  return setup.elements[index(elements.a)].is_body && setup.elements[index(elements.b)].is_body;
}

bool areMeasured(const CycleSetup& setup, ElementPairIndex pair) noexcept {
  const ElementPair& elements = setup.element_pairs[pair];
  const Element& a = setup.elements[index(elements.a)];
  const Element& b = setup.elements[index(elements.b)];
  return !areBodies(setup, pair) && a.is_exact && b.is_exact && a.padding + b.padding == 0.0;
}

bool isExact(const CycleSetup& setup, ElementPairIndex pair) noexcept {
  return areMeasured(setup, pair) && contactOfElements(setup, pair) == 0.0;
}

bool listElements(const StateSearch& state, std::size_t place) noexcept {
  StatesRefinement& refinement = state.refinement();
  bool is_known = true;
  for (const NearInStates& near : refinement.near) {
    const double distance = near.distance[place];
    is_known = is_known && !std::isnan(distance);
    if (!(distance < kInfinity)) {
      continue;
    }
    const ElementPairIndex elements = state.setup.element_pair_of[near.pair];
    std::uint32_t& listed = refinement.place_of[elements];
    if (listed == kNone) {
      listed = static_cast<std::uint32_t>(refinement.pairs.size());
      constexpr std::uint64_t kFirst = std::numeric_limits<std::uint64_t>::max();
      const std::uint64_t touched =
          areBodies(state.setup, elements) ? kFirst : refinement.touched[elements];
      refinement.pairs.push_back({elements, near.pair, distance, touched});
    } else if (distance < refinement.pairs[listed].bound) {
      refinement.pairs[listed].bodies = near.pair;
      refinement.pairs[listed].bound = distance;
    }
  }
  return is_known;
}

void forgetElements(StatesRefinement& refinement) noexcept {
  for (const ElementsInState& pair : refinement.pairs) {
    refinement.place_of[pair.elements] = kNone;
  }
  refinement.pairs.clear();
}

}  // namespace collision_monitor
