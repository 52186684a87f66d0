// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dlfcn.h>

#include <algorithm>

namespace collision_monitor::test {

/// Whether the address sanitizer watches this process: .ci/run loads a core that was built with it
/// in place of the one that the tests were linked with. The sanitizer takes what it gives from
/// memory that it has from the start, so limits of memory mean nothing to it.
inline bool isSanitized() { return dlsym(RTLD_DEFAULT, "__asan_init") != nullptr; }

/// How many cases of a long law are tried: a fifth under the sanitizer, which looks at every case
/// more closely and takes twenty times as long.
template <class Count>
Count caseCount(Count usual) {
  return isSanitized() ? std::max<Count>(1, usual / 5) : usual;
}

}  // namespace collision_monitor::test
