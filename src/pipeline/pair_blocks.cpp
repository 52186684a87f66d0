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

/// Lists the groups of slots of the last block that no block before it needs.
void addArrivals(std::vector<unsigned char>& has_arrived, PairBlocks& blocks) {
  PairBlock& block = blocks.blocks.back();
  const auto arrive = [&](std::uint32_t slot) {
    const auto group = static_cast<std::uint32_t>(slot / kBlockLanes);
    if (has_arrived[group] == 0) {
      has_arrived[group] = 1;
      blocks.arrivals.push_back(group);
    }
  };
  arrive(block.one);
  for (std::uint32_t lane = 0; lane < kBlockLanes; ++lane) {
    if ((block.is_pair >> lane & 1U) != 0) {
      arrive(block.first + lane);
    }
  }
  block.arrived = static_cast<std::uint32_t>(blocks.arrivals.size());
}

}  // namespace

PairBlocks makeBlocks(const PairTable& table, const std::vector<Core>& cores) {
  PairBlocks blocks;
  blocks.slot_of = slotsByKind(cores);
  std::vector<unsigned char> has_arrived(groupCountOf(cores.size()), 0);
  // Pairs stand ordered by kinds, then by body a, then by body b: those of a block in a row.
  for (std::size_t i = 0; i < table.size(); ++i) {
    const BodyPair& pair = table.pairs()[i];
    const std::uint32_t one = blocks.slot_of[index(pair.a)];
    const std::uint32_t other = blocks.slot_of[index(pair.b)];
    const CoreKind kind_one = cores[index(pair.a)].kind;
    const CoreKind kind_row = cores[index(pair.b)].kind;
    const bool is_new = blocks.blocks.empty() || blocks.blocks.back().one != one ||
                        blocks.ranges.back().row != kind_row ||
                        other < blocks.blocks.back().first ||
                        other >= blocks.blocks.back().first + kBlockLanes;
    if (is_new) {
      extendRanges(kind_one, kind_row, blocks);
      blocks.blocks.push_back({one, other, 0, static_cast<std::uint32_t>(i), 0});
    }
    PairBlock& block = blocks.blocks.back();
    block.is_pair |= 1U << (other - block.first);
    addArrivals(has_arrived, blocks);
  }
  return blocks;
}

BodyRows makeBodyRows(const PairBlocks& blocks, const std::vector<Core>& cores,
                      const std::vector<double>& bounding_radii) {
  BodyRows rows;
  // A block may reach beyond the last slot.
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
