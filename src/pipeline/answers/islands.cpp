// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/islands.h"

#include <algorithm>

namespace collision_monitor {
namespace {

std::uint32_t rootOf(std::vector<std::uint32_t>& parents, std::uint32_t link) noexcept {
  while (parents[link] != link) {
    parents[link] = parents[parents[link]];
    link = parents[link];
  }
  return link;
}

/// Calls `take` with the links of each pair in contact, in order.
template <class Take>
void forContacts(const std::vector<CheckedLinkPair>& checked, const PairEvents& events,
                 const Take& take) noexcept {
  for (const LinkPairIndex i : events.active) {
    if (events.verdicts[i] == Verdict::contact) {
      take(static_cast<std::uint32_t>(index(checked[i].a)),
           static_cast<std::uint32_t>(index(checked[i].b)));
    }
  }
}

}  // namespace

// Touches links in contact alone: of ten thousand objects few are.
void findIslands(const std::vector<CheckedLinkPair>& checked, PairEvents& events) noexcept {
  for (const std::uint32_t link : events.links_of_islands) {
    events.island_of_link[link] = 0;
  }
  events.links_of_islands.clear();
  events.island_count = 0;
  std::vector<std::uint32_t>& parents = events.island_forest;
  forContacts(checked, events, [&](std::uint32_t a, std::uint32_t b) {
    parents[a] = a;
    parents[b] = b;
  });
  forContacts(checked, events, [&](std::uint32_t a, std::uint32_t b) {
    a = rootOf(parents, a);
    b = rootOf(parents, b);
    parents[std::max(a, b)] = std::min(a, b);
  });
  const auto join = [&](std::uint32_t link, std::uint32_t island) {
    if (events.island_of_link[link] == 0) {
      events.links_of_islands.push_back(link);
    }
    events.island_of_link[link] = island;
  };
  forContacts(checked, events, [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t root = rootOf(parents, a);
    if (events.island_of_link[root] == 0) {
      join(root, ++events.island_count);
    }
    join(a, events.island_of_link[root]);
    join(b, events.island_of_link[root]);
  });
}

}  // namespace collision_monitor
