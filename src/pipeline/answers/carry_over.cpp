// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/carry_over.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
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

void carryPair(LinkPairIndex from, const PairMemory& reported, LinkPairIndex to,
               PairMemory& memory) noexcept {
  memory.reported[to] = reported.reported[from];
  memory.contact_detail[to] = reported.contact_detail[from];
  memory.speed.stopped[to] = reported.speed.stopped[from];
}

void carrySpeed(const SpeedScale& from, SpeedScale& to) noexcept {
  to.scale = from.scale;
  to.stamp_ns = from.stamp_ns;
}

bool comesBefore(const CheckedLinkPair& one, const CheckedLinkPair& other) noexcept {
  return std::tie(one.a, one.b) < std::tie(other.a, other.b);
}

}  // namespace

void carryOverSameLinks(const CycleSetup& from, const PairMemory& reported, const CycleSetup& to,
                        PairMemory& memory, std::vector<LinkPairIndex>& dropped) noexcept {
  dropped.clear();
  LinkPairIndex place = 0;
  for (LinkPairIndex i = 0; i < from.checked.size(); ++i) {
    while (place < to.checked.size() && comesBefore(to.checked[place], from.checked[i])) {
      ++place;
    }
    const bool is_kept =
        place < to.checked.size() && !comesBefore(from.checked[i], to.checked[place]);
    if (is_kept) {
      carryPair(i, reported, place, memory);
    } else if (reported.reported[i] != Verdict::clear) {
      dropped.push_back(i);
    }
  }
  carrySpeed(reported.speed, memory.speed);
  memory.last = reported.last;
}

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
      carryPair(i, reported, place->second, memory);
    } else if (reported.reported[i] != Verdict::clear) {
      dropped.push_back(i);
    }
  }
  carrySpeed(reported.speed, memory.speed);
  return dropped;
}

}  // namespace collision_monitor
