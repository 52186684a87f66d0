// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/data/refine_store.h"

#include <algorithm>
#include <utility>

namespace collision_monitor {
namespace {

/// Pairs of kind `never` need no memory but may have one of kind `plain`.
RefineKind slotKindOf(RefineKind kind) noexcept {
  return kind == RefineKind::never ? RefineKind::plain : kind;
}

}  // namespace

RefineRoom::RefineRoom(std::array<std::size_t, kKinds> counts, std::size_t probes)
    : probes_of_front_(std::min(probes, kMostProbes)) {
  std::size_t slots = 0;
  for (std::size_t kind = 0; kind < counts.size(); ++kind) {
    const bool is_plain = static_cast<RefineKind>(kind) == RefineKind::plain;
    counts[kind] = std::min(counts[kind], is_plain ? kMostPlain : kMostMeshes);
    orders_[kind].unmade = static_cast<std::uint32_t>(counts[kind]);
    slots += counts[kind];
  }
  const auto countOf = [&](RefineKind kind) { return counts[static_cast<std::size_t>(kind)]; };
  const std::size_t fronts = countOf(RefineKind::front) + countOf(RefineKind::both);
  pool_ = std::make_unique<FrontPool>(
      fronts == 0 ? 0 : kBlocksOfPair * std::min(fronts, kMostMeshes) + kBlocksOfAll);
  fronts_ = FixedRoom<MeshFront>(fronts);
  probes_ = FixedRoom<KeptProbe>(countOf(RefineKind::both) * probes_of_front_);
  depths_ = std::make_unique<FixedRoom<KeptDepth>>(countOf(RefineKind::depth) +
                                                   countOf(RefineKind::both));
  slots_ = FixedRoom<Slot>(slots);
}

KeptProbes RefineRoom::makeProbes() noexcept {
  const KeptProbes made{probes_.end(), probes_of_front_};
  for (std::size_t i = 0; i < made.count; ++i) {
    probes_.make();
  }
  return made;
}

/// @pre one may be made
std::uint32_t RefineRoom::makeSlot(RefineKind kind) noexcept {
  RefineMemory& memory = slots_.make().memory;
  if (kind == RefineKind::front || kind == RefineKind::both) {
    memory.front = &fronts_.make(*pool_, kind == RefineKind::both ? makeProbes() : KeptProbes());
  }
  if (kind == RefineKind::depth || kind == RefineKind::both) {
    memory.depths = depths_.get();
  }
  const auto slot = static_cast<std::uint32_t>(slots_.size() - 1);
  Order& order = orderOf(kind);
  --order.unmade;
  putFirst(order, slot);
  return slot;
}

std::uint32_t RefineRoom::take(RefineKind kind) noexcept {
  const Order& order = orderOf(kind);
  if (order.unmade > 0) {
    return makeSlot(kind);
  }
  forget(slots_[order.oldest].memory);
  return order.oldest;
}

void RefineRoom::use(RefineKind kind, std::uint32_t slot) noexcept {
  Order& order = orderOf(kind);
  if (order.newest != slot) {
    takeOut(order, slot);
    putFirst(order, slot);
  }
}

void RefineRoom::takeOut(Order& order, std::uint32_t slot) noexcept {
  const Slot& taken = slots_[slot];
  (taken.newer == kNone ? order.newest : slots_[taken.newer].older) = taken.older;
  (taken.older == kNone ? order.oldest : slots_[taken.older].newer) = taken.newer;
}

void RefineRoom::putFirst(Order& order, std::uint32_t slot) noexcept {
  slots_[slot].newer = kNone;
  slots_[slot].older = order.newest;
  (order.newest == kNone ? order.oldest : slots_[order.newest].newer) = slot;
  order.newest = slot;
}

const LastMeasurement RefineStore::kNothingMeasured{};

RefineStore::RefineStore(std::vector<RefineKind> kinds, std::size_t probes,
                         std::vector<unsigned char> is_of_object)
    : slot_of_(kinds.size(), kNone),
      kinds_(std::move(kinds)),
      is_of_object_(std::move(is_of_object)) {
  std::array<std::array<std::size_t, RefineRoom::kKinds>, 2> counts{};
  for (ElementPairIndex pair = 0; pair < kinds_.size(); ++pair) {
    ++counts[roomOf(pair)][static_cast<std::size_t>(kinds_[pair])];
  }
  for (std::size_t room = 0; room < counts.size(); ++room) {
    std::size_t& never = counts[room][static_cast<std::size_t>(RefineKind::never)];
    std::size_t& plain = counts[room][static_cast<std::size_t>(RefineKind::plain)];
    plain = std::max(plain, std::min<std::size_t>(never, 1));  // slotKindOf
    never = 0;
    rooms_[room] = RefineRoom(counts[room], probes);
  }
}

RefineMemory& RefineStore::of(ElementPairIndex pair) noexcept {
  const RefineKind kind = slotKindOf(kinds_[pair]);
  RefineRoom& room = rooms_[roomOf(pair)];
  std::uint32_t& slot = slot_of_[pair];
  if (slot == kNone) {
    slot = room.take(kind);
    const ElementPairIndex before = std::exchange(room.slots()[slot].pair, pair);
    if (before != kNone) {
      slot_of_[before] = kNone;
    }
  }
  room.use(kind, slot);
  return room.slots()[slot].memory;
}

void RefineStore::forgetAll() noexcept {
  for (RefineRoom& room : rooms_) {
    for (RefineRoom::Slot& slot : room.slots()) {
      forget(slot.memory);
    }
  }
}

void RefineStore::takeRobots(RefineStore& former,
                             const std::vector<ElementPairIndex>& new_of) noexcept {
  const auto release = [](RefineStore& store) {
    for (RefineRoom::Slot& slot : store.rooms_[0].slots()) {
      if (slot.pair != kNone) {
        store.slot_of_[slot.pair] = kNone;
      }
    }
  };
  release(*this);
  release(former);
  for (RefineRoom::Slot& slot : rooms_[0].slots()) {
    slot.pair = kNone;
    forget(slot.memory);
  }
  std::swap(rooms_[0], former.rooms_[0]);
  std::uint32_t i = 0;
  for (RefineRoom::Slot& slot : rooms_[0].slots()) {
    slot.pair = slot.pair == kNone ? kNone : new_of[slot.pair];
    if (slot.pair != kNone) {
      slot_of_[slot.pair] = i;
    }
    ++i;
  }
}

}  // namespace collision_monitor
