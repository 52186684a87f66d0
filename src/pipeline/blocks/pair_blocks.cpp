// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/pair_blocks.h"

#include <algorithm>
#include <numeric>

namespace collision_monitor {
namespace {

std::vector<std::uint32_t> slotsByKind(const std::vector<Core>& cores) {
  std::vector<std::uint32_t> bodies(cores.size());
  std::iota(bodies.begin(), bodies.end(), 0U);
  std::stable_sort(bodies.begin(), bodies.end(), [&](std::uint32_t one, std::uint32_t other) {
    return cores[one].kind < cores[other].kind;
  });
  std::vector<std::uint32_t> slot_of(cores.size());
  for (std::uint32_t slot = 0; slot < bodies.size(); ++slot) {
    slot_of[bodies[slot]] = slot;
  }
  return slot_of;
}

void extendRanges(CoreKind one, CoreKind row, PairBlocks& blocks) {
  if (blocks.ranges.empty() || blocks.ranges.back().one != one || blocks.ranges.back().row != row) {
    blocks.ranges.push_back({one, row, blocks.blocks.size(), blocks.blocks.size()});
  }
  ++blocks.ranges.back().last;
}

/// Where the fewest blocks that hold all these slots begin. Blocks begin at groups unless that
/// takes more blocks: each then reads one cache line of a column, not two.
std::vector<std::uint32_t> startsOver(const std::vector<std::uint32_t>& slots) {
  std::vector<std::uint32_t> anywhere;
  std::vector<std::uint32_t> at_groups;
  for (const std::uint32_t slot : slots) {
    if (anywhere.empty() || slot >= anywhere.back() + kBlockLanes) {
      anywhere.push_back(slot);
    }
    const auto group = static_cast<std::uint32_t>(slot - slot % kBlockLanes);
    if (at_groups.empty() || group != at_groups.back()) {
      at_groups.push_back(group);
    }
  }
  return at_groups.size() > anywhere.size() ? anywhere : at_groups;
}

/// Consecutive pairs from `first_pair` on: the body in slot `one` with the bodies in `slots`, which
/// are in ascending order.
struct PairRow {
  std::uint32_t one{0};
  std::uint32_t first_pair{0};
  std::vector<std::uint32_t> slots;
};

void addRow(CoreKind one, CoreKind other, const PairRow& row, PairBlocks& blocks) {
  std::uint32_t place = 0;
  for (const std::uint32_t first : startsOver(row.slots)) {
    extendRanges(one, other, blocks);
    PairBlock& block =
        blocks.blocks.emplace_back(PairBlock{row.one, first, 0, row.first_pair + place});
    for (; place < row.slots.size() && row.slots[place] < first + kBlockLanes; ++place) {
      block.is_pair |= 1U << (row.slots[place] - first);
    }
  }
}

}  // namespace

PairBlocks makeBlocks(const PairTable& table, const std::vector<Core>& cores) {
  PairBlocks blocks;
  blocks.slot_of = slotsByKind(cores);
  // Pairs are ordered by kinds, then by body a, then by body b.
  const std::vector<BodyPair>& pairs = table.pairs();
  for (std::size_t i = 0; i < pairs.size();) {
    const BodyId one = pairs[i].a;
    const CoreKind kind = cores[index(pairs[i].b)].kind;
    PairRow row{blocks.slot_of[index(one)], static_cast<std::uint32_t>(i), {}};
    for (; i < pairs.size() && pairs[i].a == one && cores[index(pairs[i].b)].kind == kind; ++i) {
      row.slots.push_back(blocks.slot_of[index(pairs[i].b)]);
    }
    addRow(cores[index(one)].kind, kind, row, blocks);
  }
  return blocks;
}

BodyRows makeBodyRows(const PairBlocks& blocks, const std::vector<Core>& cores,
                      const std::vector<double>& bounding_radii) {
  BodyRows rows;
  // A block may extend beyond the last slot.
  rows.stride = (groupCountOf(cores.size()) + 1) * kBlockLanes;
  rows.numbers.resize((kBoundingColumn + 1) * rows.stride, 0.0);
  for (std::size_t i = 0; i < cores.size(); ++i) {
    const std::size_t slot = blocks.slot_of[i];
    rows.at(column::radius)[slot] = cores[i].radius;
    rows.at(column::half_x)[slot] = cores[i].half_extents.x();
    rows.at(column::half_y)[slot] = cores[i].half_extents.y();
    rows.at(column::half_z)[slot] = cores[i].half_extents.z();
    rows.at(kBoundingColumn)[slot] = bounding_radii[i];
  }
  return rows;
}

}  // namespace collision_monitor
