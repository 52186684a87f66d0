// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace collision_monitor::test {

/// How many cases of a long law are tried: a fifth under sanitizers, which look at every case more
/// closely and take twenty times as long.
template <class Count>
constexpr Count caseCount(Count usual) {
#ifdef COLLISION_MONITOR_SANITIZED
  return std::max<Count>(1, usual / 5);
#else
  return usual;
#endif
}

}  // namespace collision_monitor::test
