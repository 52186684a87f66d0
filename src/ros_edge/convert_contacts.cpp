// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ros_edge/conversions.h"

namespace collision_monitor {
namespace {

/// A pair that hysteresis keeps in contact is still listed.
bool isInContact(const Watch& watch, const PairDistance& distance) {
  const std::uint32_t link_pair = watch.setup().link_pair_of[index(distance.pair)];
  const Limits& limits = watch.setup().checked[link_pair].limits;
  return watch.buffers.events.verdicts[link_pair] == Verdict::contact &&
         distance.measured.distance <= limits.contact_distance + limits.hysteresis;
}

void fill(const Watch& watch, const PairDistance& distance, Contact& message) {
  const CycleSetup& setup = watch.setup();
  const BodyPair& pair = setup.table[distance.pair];
  const LinkId link_a = setup.bodies[index(pair.a)].link;
  message.link_a = setup.model.link(link_a).name;
  message.link_b = setup.model.link(setup.bodies[index(pair.b)].link).name;
  message.shape_a = setup.labels[index(pair.a)].shape_name;
  message.shape_b = setup.labels[index(pair.b)].shape_name;
  message.quality = static_cast<std::uint8_t>(distance.quality);
  message.points.resize(1);
  toMessage(0.5 * (distance.measured.point_on_a + distance.measured.point_on_b),
            message.points.front());
  toMessage(distance.measured.normal_a_to_b, message.normal);
  message.depth = std::max(0.0, -distance.measured.distance);
  message.island = watch.buffers.events.island_of_link[index(link_a)];
}

}  // namespace

void toMessage(const Watch& watch, Contacts& message) {
  message.header = makeHeader(watch.poses.stamp_ns, watch.fixed->world_frame);
  message.island_count = watch.buffers.events.island_count;
  message.contacts.clear();
  for (const PairDistance& distance : watch.buffers.distances.measured) {
    if (isInContact(watch, distance)) {
      message.contacts.emplace_back();
      fill(watch, distance, message.contacts.back());
    }
  }
}

}  // namespace collision_monitor
