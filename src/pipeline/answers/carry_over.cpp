// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/carry_over.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace collision_monitor {
namespace {

using FramePair = std::pair<std::string, std::string>;

/// The tf frames of two links, in an order that does not depend on that of the links.
FramePair framesOf(const CycleSetup& setup, const CheckedLinkPair& pair) {
  const std::string& a = setup.model.link(pair.a).frame;
  const std::string& b = setup.model.link(pair.b).frame;
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

std::vector<LinkPairIndex> carryOver(const CycleSetup& from, const PairMemory& reported,
                                     const CycleSetup& to, PairMemory& memory) {
  std::map<FramePair, LinkPairIndex> places;
  for (LinkPairIndex i = 0; i < to.checked.size(); ++i) {
    places.emplace(framesOf(to, to.checked[i]), i);
  }
  std::vector<LinkPairIndex> dropped;
  for (LinkPairIndex i = 0; i < from.checked.size(); ++i) {
    const auto place = places.find(framesOf(from, from.checked[i]));
    if (place != places.end()) {
      memory.reported[place->second] = reported.reported[i];
      memory.contact_detail[place->second] = reported.contact_detail[i];
      memory.speed.stopped[place->second] = reported.speed.stopped[i];
    } else if (reported.reported[i] != Verdict::clear) {
      dropped.push_back(i);
    }
  }
  memory.speed.scale = reported.speed.scale;
  memory.speed.stamp_ns = reported.speed.stamp_ns;
  return dropped;
}

}  // namespace collision_monitor
