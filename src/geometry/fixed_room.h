// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <utility>

namespace collision_monitor {

/// Room for a fixed number of things, which are made one by one and stay where they are. Making one
/// allocates nothing. Room for many things costs little while few are made: the system gives memory
/// when it is first touched.
template <class Thing>
class FixedRoom {
 public:
  FixedRoom() = default;
  explicit FixedRoom(std::size_t most) : most_(most) {
    things_ = most > 0 ? std::allocator<Thing>().allocate(most) : nullptr;
  }
  FixedRoom(const FixedRoom&) = delete;
  FixedRoom& operator=(const FixedRoom&) = delete;
  FixedRoom(FixedRoom&& other) noexcept { swap(other); }
  FixedRoom& operator=(FixedRoom&& other) noexcept {
    FixedRoom(std::move(other)).swap(*this);
    return *this;
  }
  ~FixedRoom() {
    std::destroy_n(things_, size_);
    if (things_ != nullptr) {
      std::allocator<Thing>().deallocate(things_, most_);
    }
  }

  /// Without arguments, numbers that have no initializer of their own are left as the memory is:
  /// zeros in large arrays would only be written over.
  /// @pre size() < most()
  template <class... Arguments>
  Thing& make(Arguments&&... arguments) {
    assert(size_ < most_);
    void* const place = things_ + size_;
    ++size_;
    if constexpr (sizeof...(Arguments) == 0) {
      return *::new (place) Thing;
    } else {
      return *::new (place) Thing{std::forward<Arguments>(arguments)...};
    }
  }

  std::size_t size() const noexcept { return size_; }
  std::size_t most() const noexcept { return most_; }
  Thing& operator[](std::size_t i) noexcept { return things_[i]; }
  const Thing& operator[](std::size_t i) const noexcept { return things_[i]; }
  Thing* begin() noexcept { return things_; }
  Thing* end() noexcept { return things_ + size_; }

 private:
  void swap(FixedRoom& other) noexcept {
    std::swap(things_, other.things_);
    std::swap(size_, other.size_);
    std::swap(most_, other.most_);
  }

  Thing* things_{nullptr};
  std::size_t size_{0};
  std::size_t most_{0};
};

}  // namespace collision_monitor
