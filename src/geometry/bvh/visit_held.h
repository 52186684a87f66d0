// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>

namespace collision_monitor {

/// std::visit for one variant, without its exception for a variant that lost its value. The
/// variants of a cycle hold types whose copies cannot throw, so they always hold a value.
template <std::size_t kAlternative = 0, class Visitor, class Variant>
constexpr decltype(auto) visitHeld(const Visitor& visitor, Variant& variant) noexcept {
  constexpr std::size_t kCount = std::variant_size_v<std::remove_const_t<Variant>>;
  auto* held = std::get_if<kAlternative>(&variant);
  if constexpr (kAlternative + 1 == kCount) {
    return visitor(*held);
  } else {
    return held != nullptr ? visitor(*held) : visitHeld<kAlternative + 1>(visitor, variant);
  }
}

}  // namespace collision_monitor
