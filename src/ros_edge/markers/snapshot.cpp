// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/snapshot.h"

#include <algorithm>

#include "collision_monitor/geometry/ids.h"
#include "ros_edge/markers/labels.h"

namespace collision_monitor {
namespace {

void takeLinks(const Watch& watch, std::vector<Snapshot::Link>& links) {
  const BodyPoses& poses = watch.buffers.body_poses;
  links.resize(watch.setup().model.links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    links[i] = {watch.poses.world_from_link[i], watch.poses.part[i], poses.link_known[i] != 0,
                Verdict::clear};
  }
  const PairEvents& events = watch.buffers.events;
  for (const LinkPairIndex i : events.active) {
    // An unknown pair says nothing about this link: its partner may be the cause.
    if (events.verdicts[i] != Verdict::unknown) {
      const CheckedLinkPair& pair = watch.setup().checked[i];
      for (const LinkId link : {pair.a, pair.b}) {
        Verdict& worst = links[index(link)].worst;
        worst = std::max(worst, events.verdicts[i]);
      }
    }
  }
}

void takeContacts(const Watch& watch, std::vector<Snapshot::Contact>& contacts) {
  contacts.clear();
  for (const PairDistance& distance : watch.buffers.distances.pairs) {
    if (isInContact(watch, distance)) {
      contacts.push_back(
          {distance.pair, contactPointsOf(watch, distance), distance.measured.normal_a_to_b});
    }
  }
  for (const PassedContact& passed : watch.buffers.distances.passed) {
    const SignedDistance& measured = passed.distance.measured;
    contacts.push_back({passed.distance.pair, onePointOf(measured), measured.normal_a_to_b});
  }
}

void takeLines(const Watch& watch, std::vector<Snapshot::Line>& lines) {
  lines.clear();
  const PairEvents& events = watch.buffers.events;
  for (const LinkPairIndex i : events.active) {
    const std::uint32_t place = events.closest[i];
    if (place == kNone) {
      continue;
    }
    const SignedDistance& measured = watch.buffers.distances.pairs[place].measured;
    if (place == events.closest_of_all ||
        measured.distance <= limitsOf(watch.setup(), i).report_distance) {
      lines.push_back({i, measured.point_on_a, measured.point_on_b, events.verdicts[i]});
    }
  }
}

void takeLabels(const Watch& watch, std::vector<Snapshot::Label>& labels) {
  labels.clear();
  for (const LinkPairIndex i : chooseLabelled(watch, watch.fixed->parameters.marker_labels)) {
    const PairDistance& closest = watch.buffers.distances.pairs[watch.buffers.events.closest[i]];
    const SignedDistance& measured = closest.measured;
    labels.push_back(
        {i, 0.5 * (measured.point_on_a + measured.point_on_b), measured.distance, closest.quality});
  }
}

}  // namespace

void takeSnapshot(const Watch& watch, Snapshot& snapshot) {
  snapshot.fixed = watch.fixed;
  snapshot.stamp_ns = watch.poses.stamp_ns;
  takeLinks(watch, snapshot.links);
  takeContacts(watch, snapshot.contacts);
  takeLines(watch, snapshot.lines);
  takeLabels(watch, snapshot.labels);
}

}  // namespace collision_monitor
