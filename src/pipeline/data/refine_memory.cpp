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
  std::unique_ptr<MeshFront> front = std::move(memory.front);
  std::unique_ptr<KeptDepth> depth = std::move(memory.depth);
  memory = RefineMemory();
  memory.front = std::move(front);
  memory.depth = std::move(depth);
  if (memory.front) {
    memory.front->pool.clear(*memory.front);
    memory.front->resting_from_moving.reset();
    memory.front->nearest.a = kNone;
  }
  if (memory.depth) {
    forget(*memory.depth);
  }
}

RefineStore::RefineStore(std::vector<RefineKind> kinds)
    : slot_of_(kinds.size(), kNone), kinds_(std::move(kinds)) {
  const auto with_front =
      static_cast<std::size_t>(std::count_if(kinds_.begin(), kinds_.end(), [](RefineKind kind) {
        return kind == RefineKind::front || kind == RefineKind::both;
      }));
  pool_ = std::make_unique<FrontPool>(
      with_front == 0 ? 0 : kBlocksOfPair * std::min(with_front, kMostMeshes) + kBlocksOfAll);
  for (const RefineKind kind :
       {RefineKind::plain, RefineKind::front, RefineKind::depth, RefineKind::both}) {
    const auto pairs = static_cast<std::size_t>(std::count(kinds_.begin(), kinds_.end(), kind));
    const bool is_plain = kind == RefineKind::plain;
    const std::size_t least = is_plain && !kinds_.empty() ? 1 : 0;  // slotKindOf
    addSlots(kind, std::max(least, std::min(pairs, is_plain ? kMostPlain : kMostMeshes)));
  }
}

void RefineStore::addSlots(RefineKind kind, std::size_t count) {
  slots_.reserve(slots_.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    RefineMemory& memory = slots_.emplace_back().memory;
    if (kind == RefineKind::front || kind == RefineKind::both) {
      memory.front = std::make_unique<MeshFront>(*pool_);
    }
    if (kind == RefineKind::depth || kind == RefineKind::both) {
      memory.depth = std::make_unique<KeptDepth>();
    }
    putFirst(orders_[static_cast<std::size_t>(kind)],
             static_cast<std::uint32_t>(slots_.size() - 1));
  }
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
  Order& order = orders_[static_cast<std::size_t>(slotKindOf(kinds_[pair]))];
  std::uint32_t& slot = slot_of_[pair];
  if (slot == kNone) {
    slot = order.oldest;
    Slot& taken = slots_[slot];
    if (taken.pair != kNone) {
      slot_of_[taken.pair] = kNone;
      forget(taken.memory);
    }
    taken.pair = pair;
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
