// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "islands.h"

#include <algorithm>
#include <numeric>

namespace collision_monitor {
namespace {

std::uint32_t rootOf(std::vector<std::uint32_t>& parents, std::uint32_t link) noexcept {
  while (parents[link] != link) {
    parents[link] = parents[parents[link]];
    link = parents[link];
  }
  return link;
}

}  // namespace

void findIslands(const std::vector<CheckedLinkPair>& checked, PairEvents& events) noexcept {
  std::vector<std::uint32_t>& parents = events.island_forest;
  std::iota(parents.begin(), parents.end(), 0U);
  for (const LinkPairIndex i : events.active) {
    if (events.verdicts[i] == Verdict::contact) {
      const std::uint32_t a = rootOf(parents, static_cast<std::uint32_t>(index(checked[i].a)));
      const std::uint32_t b = rootOf(parents, static_cast<std::uint32_t>(index(checked[i].b)));
      parents[std::max(a, b)] = std::min(a, b);
    }
  }
  std::fill(events.island_of_link.begin(), events.island_of_link.end(), 0U);
  events.island_count = 0;
  for (const LinkPairIndex i : events.active) {
    if (events.verdicts[i] == Verdict::contact) {
      const std::uint32_t root = rootOf(parents, static_cast<std::uint32_t>(index(checked[i].a)));
      std::uint32_t& number = events.island_of_link[root];
      if (number == 0) {
        number = ++events.island_count;
      }
      events.island_of_link[index(checked[i].a)] = number;
      events.island_of_link[index(checked[i].b)] = number;
    }
  }
}

}  // namespace collision_monitor
