// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pthread.h>

#include <mutex>

namespace collision_monitor {

/// A mutex that the cycle's thread shares with others. While that waits for another thread, the
/// other has its priority: nothing of normal priority delays it. Source: Sha, Rajkumar, Lehoczky,
/// "Priority inheritance protocols", IEEE Transactions on Computers 39 (1990).
class InheritingMutex : public std::mutex {
 public:
  InheritingMutex() {
    pthread_mutexattr_t attributes;
    pthread_mutexattr_init(&attributes);
    pthread_mutexattr_setprotocol(&attributes, PTHREAD_PRIO_INHERIT);
    pthread_mutex_destroy(native_handle());
    if (pthread_mutex_init(native_handle(), &attributes) != 0) {  // the kernel cannot
      pthread_mutex_init(native_handle(), nullptr);
    }
    pthread_mutexattr_destroy(&attributes);
  }
};

}  // namespace collision_monitor
