// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/distance_list.h"

#include <algorithm>

#include "collision_monitor/geometry/ids.h"
#include "ros_edge/outputs/conversions.h"

namespace collision_monitor {
namespace {

bool isListed(const Watch& watch, LinkPairIndex link_pair) {
  const PairEvents& events = watch.buffers.events;
  const std::uint32_t place = events.closest[link_pair];
  return place != kNone && (place == events.closest_of_all || events.passed[link_pair] != kNone ||
                            !(watch.buffers.distances.pairs[place].measured.distance >
                              limitsOf(watch.setup(), link_pair).report_distance));
}

}  // namespace

const Distances& DistanceList::fill(const Watch& watch) {
  const CycleSetup& setup = watch.setup();
  const PairEvents& events = watch.buffers.events;
  message_.header = makeHeader(watch.poses.stamp_ns, watch.fixed->world_frame);
  message_.closest = -1;
  message_.pairs_checked = static_cast<std::uint32_t>(setup.checked.size());
  message_.pairs_unknown = static_cast<std::uint32_t>(events.unknown);
  message_.truncated = 0;
  message_.tolerance = setup.refine.tolerance;
  GradientRows rows(setup, watch.poses);
  size_ = 0;
  for (const LinkPairIndex i : events.active) {
    if (!isListed(watch, i)) {
      continue;
    }
    if (events.closest[i] == events.closest_of_all) {
      message_.closest = static_cast<std::int32_t>(size_);
    }
    const PairDistance& distance = watch.buffers.distances.pairs[events.closest[i]];
    fillEntry(setup, distance, rows.of(distance));
    message_.pairs[size_].frame_id = frameOf(*watch.fixed, watch.poses, setup.checked[i].a);
    message_.pairs[size_++].passed_at = passedAt(watch, i);
  }
  message_.pairs.resize(size_);
  named_.resize(size_);
  return message_;
}

void DistanceList::fillEntry(const CycleSetup& setup, const PairDistance& distance,
                             const GradientRow& row) {
  message_.pairs.resize(std::max(message_.pairs.size(), size_ + 1));
  named_.resize(message_.pairs.size());
  LinkDistance& entry = message_.pairs[size_];
  Named& named = named_[size_];
  if (!named.by_anyone || named.pair != distance.pair || named.is_refined != distance.is_refined) {
    nameBodies(setup, distance, entry);
    nameJoints(setup, row, entry);
    named = {true, distance.pair, distance.is_refined};
  }
  fillNumbers(distance, entry);
  fillNumbers(row, entry);
}

}  // namespace collision_monitor
