// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "collision_monitor/pipeline/contact_manifold.h"
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

void fillPoints(const Watch& watch, const PairDistance& distance, Contact& message) {
  const auto manifold = contactManifold(watch.setup(), watch.buffers.body_poses, distance);
  if (!manifold) {
    message.points.resize(1);
    toMessage(0.5 * (distance.measured.point_on_a + distance.measured.point_on_b),
              message.points.front());
    message.feature.clear();
    return;
  }
  message.points.resize(manifold->size);
  for (std::size_t i = 0; i < manifold->size; ++i) {
    const ManifoldPoint& point = manifold->points[i];
    toMessage(0.5 * (point.point_on_a + point.point_on_b), message.points[i]);
  }
  message.feature = nameOf(manifold->feature);
}

void fill(const Watch& watch, const PairDistance& distance, Contact& message) {
  const CycleSetup& setup = watch.setup();
  const BodyPair& pair = setup.table[distance.pair];
  const LinkId link_a = setup.bodies[index(pair.a)].link;
  message.link_a = setup.model.link(link_a).name;
  message.link_b = setup.model.link(setup.bodies[index(pair.b)].link).name;
  message.shape_a = shapeName(setup, distance, pair.a);
  message.shape_b = shapeName(setup, distance, pair.b);
  message.quality = static_cast<std::uint8_t>(distance.quality);
  fillPoints(watch, distance, message);
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
