// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/data/refine_memory.h"

#include <algorithm>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "geometry/ball_motion.h"

namespace collision_monitor {
namespace {

/// Pairs of kind `never` need no memory but may have one of kind `plain`.
RefineKind slotKindOf(RefineKind kind) noexcept {
  return kind == RefineKind::never ? RefineKind::plain : kind;
}

}  // namespace

const LastMeasurement RefineStore::kNothingMeasured{};

void remember(const LastMeasurement& measurement, RefineMemory& memory) noexcept {
  if (!isSame(memory.last.world_from_a, measurement.world_from_a) ||
      !isSame(memory.last.world_from_b, measurement.world_from_b)) {
    memory.before = memory.last;
  }
  memory.last = measurement;
}

void forget(RefineMemory& memory) noexcept {
  MeshFront* const front = memory.front;
  KeptDepth* const depth = memory.depth;
  FixedRoom<KeptDepth>* const depths = memory.depths;
  memory = RefineMemory();
  memory.front = front;
  memory.depth = depth;
  memory.depths = depths;
  if (memory.front != nullptr) {
    memory.front->pool.clear(*memory.front);
    memory.front->resting_from_moving.reset();
    memory.front->nearest.a = kNone;
  }
  if (memory.depth != nullptr) {
    forget(*memory.depth);
  }
}

KeptDepth* keptDepth(RefineMemory& memory) noexcept {
  if (memory.depth == nullptr && memory.depths != nullptr) {
    memory.depth = &memory.depths->make();
  }
  return memory.depth;
}

RefineStore::RefineStore(std::vector<RefineKind> kinds)
    : slot_of_(kinds.size(), kNone), kinds_(std::move(kinds)) {
  std::array<std::size_t, 5> counts{};
  for (const RefineKind kind : kinds_) {
    ++counts[static_cast<std::size_t>(kind)];
  }
  const auto countOf = [&](RefineKind kind) -> std::size_t& {
    return counts[static_cast<std::size_t>(kind)];
  };
  countOf(RefineKind::never) = 0;
  const std::size_t least = kinds_.empty() ? 0 : 1;  // slotKindOf
  countOf(RefineKind::plain) = std::max(least, countOf(RefineKind::plain));
  std::size_t slots = 0;
  for (std::size_t kind = 0; kind < counts.size(); ++kind) {
    const bool is_plain = static_cast<RefineKind>(kind) == RefineKind::plain;
    counts[kind] = std::min(counts[kind], is_plain ? kMostPlain : kMostMeshes);
    orders_[kind].unmade = static_cast<std::uint32_t>(counts[kind]);
    slots += counts[kind];
  }
  const std::size_t fronts = countOf(RefineKind::front) + countOf(RefineKind::both);
  pool_ = std::make_unique<FrontPool>(
      fronts == 0 ? 0 : kBlocksOfPair * std::min(fronts, kMostMeshes) + kBlocksOfAll);
  fronts_ = FixedRoom<MeshFront>(fronts);
  depths_ = std::make_unique<FixedRoom<KeptDepth>>(countOf(RefineKind::depth) +
                                                   countOf(RefineKind::both));
  slots_ = FixedRoom<Slot>(slots);
}

/// @pre one may be made
std::uint32_t RefineStore::makeSlot(RefineKind kind) noexcept {
  RefineMemory& memory = slots_.make().memory;
  if (kind == RefineKind::front || kind == RefineKind::both) {
    memory.front = &fronts_.make(*pool_);
  }
  if (kind == RefineKind::depth || kind == RefineKind::both) {
    memory.depths = depths_.get();
  }
  const auto slot = static_cast<std::uint32_t>(slots_.size() - 1);
  Order& order = orders_[static_cast<std::size_t>(kind)];
  --order.unmade;
  putFirst(order, slot);
  return slot;
}

/// A slot that has no pair: a new one, or the one that was asked for longest ago.
std::uint32_t RefineStore::takeSlot(RefineKind kind) noexcept {
  const Order& order = orders_[static_cast<std::size_t>(kind)];
  if (order.unmade > 0) {
    return makeSlot(kind);
  }
  Slot& taken = slots_[order.oldest];
  slot_of_[taken.pair] = kNone;
  forget(taken.memory);
  return order.oldest;
}

void RefineStore::takeOut(Order& order, std::uint32_t slot) noexcept {
  const Slot& taken = slots_[slot];
  (taken.newer == kNone ? order.newest : slots_[taken.newer].older) = taken.older;
  (taken.older == kNone ? order.oldest : slots_[taken.older].newer) = taken.newer;
}

void RefineStore::putFirst(Order& order, std::uint32_t slot) noexcept {
  slots_[slot].newer = kNone;
  slots_[slot].older = order.newest;
  (order.newest == kNone ? order.oldest : slots_[order.newest].newer) = slot;
  order.newest = slot;
}

RefineMemory& RefineStore::of(ElementPairIndex pair) noexcept {
  const RefineKind kind = slotKindOf(kinds_[pair]);
  Order& order = orders_[static_cast<std::size_t>(kind)];
  std::uint32_t& slot = slot_of_[pair];
  if (slot == kNone) {
    slot = takeSlot(kind);
    slots_[slot].pair = pair;
  }
  if (order.newest != slot) {
    takeOut(order, slot);
    putFirst(order, slot);
  }
  return slots_[slot].memory;
}

void RefineStore::forgetAll() noexcept {
  for (Slot& slot : slots_) {
    forget(slot.memory);
  }
}

}  // namespace collision_monitor
