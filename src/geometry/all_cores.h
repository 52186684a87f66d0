// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace collision_monitor {

/// Calls work(0) to work(count - 1), each once, on as many threads as there are processors; this
/// thread is one of them. Returns when all are done.
///
/// Jobs that are independent give the same whatever the number of threads. throwIfInterrupted
/// asks within a job what it asks on this thread, never on two threads at once, and as
/// often in all as one thread alone would.
/// @throws what a job threw, that of the first job if there are several; after Interrupted no job
/// begins any more.
void forEachOnAllCores(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace collision_monitor
