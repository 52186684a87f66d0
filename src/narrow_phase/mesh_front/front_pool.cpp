// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_front/mesh_front.h"

namespace collision_monitor {

FrontPool::FrontPool(std::size_t blocks) : blocks_(blocks) { free_.reserve(blocks); }

bool FrontPool::isEmpty() const noexcept {
  return free_.empty() && blocks_.size() == blocks_.most();
}

MeshFront::Block* FrontPool::take() noexcept {
  if (free_.empty()) {
    return &blocks_.make();
  }
  MeshFront::Block* block = free_.back();
  free_.pop_back();
  return block;
}

bool FrontPool::grow(MeshFront& front) noexcept {
  // Queries of any front until an unused one loses its blocks. Fronts of every cycle keep theirs.
  constexpr std::uint64_t kUnasked = 5000;
  if (front.block_count == MeshFront::kMostBlocks) {
    return false;
  }
  if (isEmpty() && oldest_ != nullptr && oldest_->followed_at + kUnasked < clock_) {
    clear(*oldest_);
  }
  if (isEmpty()) {
    return false;
  }
  if (front.block_count == 0) {
    putNewest(front);
  }
  front.blocks[front.block_count++] = take();
  return true;
}

void FrontPool::clear(MeshFront& front) noexcept {
  if (front.block_count > 0) {
    takeOut(front);
  }
  while (front.block_count > 0) {
    free_.push_back(front.blocks[--front.block_count]);
  }
  front.size = 0;
  front.cover = -std::numeric_limits<double>::infinity();
}

void FrontPool::touch(MeshFront& front) noexcept {
  front.followed_at = ++clock_;
  if (front.block_count > 0 && newest_ != &front) {
    takeOut(front);
    putNewest(front);
  }
}

void FrontPool::takeOut(MeshFront& front) noexcept {
  (front.newer == nullptr ? newest_ : front.newer->older) = front.older;
  (front.older == nullptr ? oldest_ : front.older->newer) = front.newer;
}

void FrontPool::putNewest(MeshFront& front) noexcept {
  front.newer = nullptr;
  front.older = newest_;
  (newest_ == nullptr ? oldest_ : newest_->newer) = &front;
  newest_ = &front;
}

}  // namespace collision_monitor
