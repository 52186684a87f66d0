// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace collision_monitor {

/// Ids are dense indices into the arrays of their set-up. Their types are distinct, so a body
/// cannot be used as a pair. Names are looked up at the ROS edge and nowhere else.
enum class BodyId : std::uint32_t {};  ///< one shape fixed to a link
/// Two bodies that may touch.
enum class PairId : std::uint32_t {};  ///< two bodies that may touch

/// No index.
constexpr std::uint32_t kNone = 0xffffffffU;

/// The position of what `id` names in the arrays of its set-up.
template <class Id>
constexpr std::size_t index(Id id) noexcept {
  return static_cast<std::size_t>(id);
}

/// The id of what stands at a position. @pre position < kNone
template <class Id>
constexpr Id idAt(std::size_t position) noexcept {
  return static_cast<Id>(static_cast<std::uint32_t>(position));
}

}  // namespace collision_monitor
