// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "product_coal.h"

#include <algorithm>
#include <cmath>

#include "peer_times.h"
#include "peers/coal_elements.h"

namespace collision_monitor::test {
namespace {

/// Prints how often Coal contradicts FCL, and how far its distances are from ours.
void compare(const CycleSetup& setup, const std::vector<CoalObjects>& states,
             const std::vector<KnownState>& known) {
  std::size_t other_contacts = 0;
  double worst = 0.0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (known[i].is_sure) {
      other_contacts += (coalContacts(setup, states[i]) > 0) != known[i].meets ? 1 : 0;
    }
    if (known[i].distance > 0.0) {
      worst = std::max(worst, std::abs(coalLeast(setup, states[i]) - known[i].distance));
    }
  }
  print("states_coal_other_contacts", other_contacts);
  print("states_coal_worst_distance", worst, "m");
}

}  // namespace

void measureCoal(const CycleSetup& setup, const std::vector<std::vector<Pose>>& world_from_element,
                 const std::vector<KnownState>& known) {
  const std::vector<CoalGeometry> geometries = coalGeometries(setup);
  std::vector<CoalObjects> states;
  for (const std::vector<Pose>& poses : world_from_element) {
    states.push_back(placeCoal(geometries, poses));
  }
  const auto time = [&](const char* name, const auto& query) {
    timePeer(name, states.size(), [&](std::size_t state) { query(setup, states[state]); });
  };
  time("states_coal_collide", coalContacts);
  time("states_coal_least", coalLeast);
  time("states_coal_every_distance", coalLeastOfEvery);
  compare(setup, states, known);
}

}  // namespace collision_monitor::test
