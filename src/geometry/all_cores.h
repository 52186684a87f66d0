// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace collision_monitor {

/// Calls work(0) to work(count - 1) once each, on as many threads as there are processors. The
/// calling thread is one of them. Returns when all jobs are done.
///
/// Independent jobs give the same result for any number of threads. Inside a job,
/// throwIfInterrupted asks the calling thread's question: never on two threads at once, and in
/// total as often as a single thread would.
/// @throws what a job threw: the first job's exception if there are several. After Interrupted no
/// further job begins.
void forEachOnAllCores(std::size_t count, const std::function<void(std::size_t)>& work);

/// From so many triangles on, threads save more time than they cost.
constexpr std::size_t kManyTriangles = 5000;

/// Does two independent things, at the same time if wanted.
void doBoth(bool at_once, const std::function<void()>& one, const std::function<void()>& other);

}  // namespace collision_monitor
